#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Usage: check_words.py SOURCE COMPILER ARGUMENTS...

Compiles SOURCE, which must fail. For each of its constants that ends with `// word`, the messages about its lines
must contain the word, and no other line may be wrong.
"""
import re
import subprocess
import sys

source, *compiler = sys.argv[1:]
messages = subprocess.run([*compiler, source], capture_output=True, text=True).stderr
# What is printed of one error: up to the next one.
errors = {}
line = 0
for text in messages.splitlines():
    found = re.search(re.escape(source) + r":(\d+):\d+: +(error|in)\b", text)
    if found:
        line = int(found.group(1))
    errors[line] = errors.get(line, "") + text + "\n"
wrong = []
expected = {}
begin = 0
for number, text in enumerate(open(source), 1):
    if text.startswith("constexpr"):
        begin = number
    word = re.search(r"; +// (\w+)$", text)
    if word:
        expected[range(begin, number + 1)] = word.group(1)
for lines, word in expected.items():
    about = "".join(errors.pop(line, "") for line in lines)
    if not re.search(rf"\b{word}\b", about):
        wrong.append(f"{source}:{lines[0]}: no message contains {word}:\n{about}")
wrong += [f"{source}:{line}: unexpected:\n{text}" for line, text in errors.items() if line]
print("\n".join(wrong) or f"{len(expected)} constants are refused by their names")
sys.exit(bool(wrong) or not expected)
