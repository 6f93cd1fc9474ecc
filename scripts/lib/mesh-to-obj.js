// SPDX-License-Identifier: MIT
// node mesh-to-obj.js PACKAGE_FOLDER: writes the simplicial complex that an npm mesh package exports as OBJ.
'use strict';
const path = require('path');
const mesh = require(path.resolve(process.argv[2]));
const lines = [];
for (const p of mesh.positions) lines.push(`v ${p.join(' ')}`);
for (const c of mesh.cells) lines.push(`f ${c.map((i) => i + 1).join(' ')}`);
process.stdout.write(lines.join('\n') + '\n');
