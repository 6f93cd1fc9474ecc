# SPDX-License-Identifier: MIT
"""Assigns each instruction of a firmware image to a part of a frame, so that the emulator counts the parts by address.

The image must have line tables (gcc -g1), which tell which inlined functions an instruction belongs to. The PARTS are:

* pixel: loops of draw_pixels(), and functions that only these call;
* row: loops of RowDrawer and draw_small_pixels(), without their pixels, and functions that only these call;
* vertex: transformation, projection and shading of vertices, unpacking of normals;
* back face: BackFaces, which culls by planes;
* triangle: everything else between two marks, such as preparation and culling by area.

A loop is a strongly connected part of the control flow. It belongs to a function if most of its instructions were inlined
from there: the compiler moves some across the borders. A function that several parts call, such as a 64-bit product, is
divided among them by the number of calls.
"""

import functools
import re
import subprocess
from collections import Counter, defaultdict

PARTS = ("pixel", "row", "triangle", "vertex", "back face")
LOOPS = (("pixel", re.compile(r"::draw_pixels$")), ("row", re.compile(r"::(Inlined)?RowDrawer::|::draw_small_pixels$")))
INLINED = (("vertex", re.compile(r"::(VertexStage|ClipTransform)::|::(project|unpack_normal|shade_vertex)$")),
           ("back face", re.compile(r"::BackFaces::")))
MOST = 0.8  # of a loop's instructions


class Instruction:
    def __init__(self, address, function, mnemonic, operands):
        self.address, self.function, self.mnemonic = address, function, mnemonic
        target = re.match(r"(?:r\d+, )?([0-9a-f]+) <", operands)
        self.target = int(target[1], 16) if target and re.match(r"b[a-z]{0,3}(\.[nw])?$|cbn?z$", mnemonic) else None
        self.calls = mnemonic in ("bl", "blx") and self.target is not None
        # What follows a branch that is always taken, or a return, is reached from elsewhere.
        self.ends = bool(re.match(r"(b|bx)(\.[nw])?$|udf", mnemonic)) or (
            bool(re.match(r"pop|ldm|ldr|mov", mnemonic)) and re.search(r"(^|\b)pc(\b|\})", operands.split("[")[0]) is not None)
        self.chain = []
        self.part = None

    def is_inlined_from(self, name):
        return any(name.search(function) for function in self.chain)


def disassemble(image, prefix):
    """The image's instructions, in order of their addresses."""
    text = subprocess.run([prefix + "objdump", "-d", "--no-show-raw-insn", image], check=True, capture_output=True,
                          text=True).stdout
    instructions, function = [], ""
    for line in text.splitlines():
        if label := re.match(r"[0-9a-f]+ <(.+)>:$", line):
            function = label[1].removesuffix(".cold")
        elif found := re.match(r" *([0-9a-f]+):\t([a-z][a-z0-9.]*)(?:\t(.*))?$", line):
            instructions.append(Instruction(int(found[1], 16), function, found[2], found[3] or ""))
    return instructions


def plain_name(function):
    """A demangled name without return type, arguments and parameters of templates: arcspan::RowDrawer::draw."""
    function = function.replace("(anonymous namespace)", "anonymous").replace("operator()", "call").split(" [clone")[0]
    name, depth = "", 0
    for c in re.sub(r"operator(<<|>>|<=>|<|>|->)=?", "operator", function):
        if c == "(" and depth == 0:
            break
        depth += (c == "<") - (c == ">")
        if depth == 0 and c != ">":
            name += c
    return name.split(" ")[-1]


def read_inlining(image, prefix, instructions):
    """Sets each instruction's chain: plain names of the functions that it was inlined from, innermost first."""
    addresses = "".join(f"{i.address:x}\n" for i in instructions)
    text = subprocess.run([prefix + "addr2line", "-e", image, "-a", "-i", "-f", "-C"], input=addresses, check=True,
                          capture_output=True, text=True).stdout
    chains = re.split(r"^0x[0-9a-f]+\n", text, flags=re.MULTILINE)[1:]
    plain = functools.cache(plain_name)
    symbols = sorted({i.function for i in instructions})
    text = subprocess.run([prefix + "c++filt"], input="\n".join(symbols), check=True, capture_output=True, text=True).stdout
    demangled = dict(zip(symbols, text.splitlines()))
    for instruction, chain in zip(instructions, chains):
        functions = [function for function in chain.splitlines()[::2] if function != "??"]
        instruction.chain = [plain(function) for function in functions or [demangled[instruction.function]]]


def successors(function, following):
    """The control flow within a function: sets of addresses by address."""
    inside = {i.address for i in function}
    flow = {}
    for i in function:
        jumps = i.target is not None and not (i.calls and i.target == function[0].address)
        far = i.calls and i.target in inside  # Armv6-M jumps far by BL
        next_ones = set() if i.ends or far else {following.get(i.address)}
        if jumps:
            next_ones.add(i.target)
        flow[i.address] = next_ones & inside
    return flow


def strongly_connected(nodes, flow):
    """Tarjan's algorithm without recursion; yields the components that are loops."""
    index, low, on_stack, stack = {}, {}, set(), []
    for root in nodes:
        if root in index:
            continue
        work = [(root, iter(flow[root] & nodes))]
        index[root] = low[root] = len(index)
        stack.append(root)
        on_stack.add(root)
        while work:
            node, ahead = work[-1]
            step = next(ahead, None)
            if step is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    component = set()
                    while node not in component:
                        component.add(stack.pop())
                    on_stack -= component
                    if len(component) > 1 or node in flow[node]:
                        yield component
            elif step not in index:
                index[step] = low[step] = len(index)
                stack.append(step)
                on_stack.add(step)
                work.append((step, iter(flow[step] & nodes)))
            elif step in on_stack:
                low[node] = min(low[node], index[step])


def loops(nodes, flow, depth):
    """All loops among the nodes, outer ones first: a loop without its entry holds the loops inside it. Of several entries,
    which optimised loops have, the one of the least depth of inlining is the outer loop's."""
    for loop in strongly_connected(nodes, flow):
        yield loop
        entries = {step for node in flow.keys() - loop for step in flow[node] & loop} or loop
        yield from loops(loop - {min(entries, key=lambda entry: (depth[entry], entry))}, flow, depth)


def mark_loops(function, flow, by_address):
    depth = {address: len(by_address[address].chain) for address in flow}
    for loop in loops(set(flow), flow, depth):
        for part, name in LOOPS:
            if sum(by_address[a].is_inlined_from(name) for a in loop) >= MOST * len(loop):
                for address in loop:
                    by_address[address].part = part
                break
    # Where both loops share entries, as on Armv6-M with its far jumps, the pixels are a loop among their own instructions.
    part, name = LOOPS[0]
    for loop in strongly_connected({address for address in flow if by_address[address].is_inlined_from(name)}, flow):
        for address in loop:
            by_address[address].part = part


def callers(instructions, starts):
    """The calls and tail calls of each function, as instructions."""
    found = defaultdict(list)
    for i in instructions:
        if i.target in starts and starts[i.target] != i.function:
            found[starts[i.target]].append(i)
    return found


def classify(image, prefix="arm-none-eabi-"):
    """Returns ranges (first address, size, name) for instruction_count: names are parts, "shared FUNCTION" for functions of
    several parts, and "call PART > FUNCTION" for calls of these."""
    instructions = disassemble(image, prefix)
    read_inlining(image, prefix, instructions)
    by_address = {i.address: i for i in instructions}
    following = {a.address: b.address for a, b in zip(instructions, instructions[1:])}
    functions = defaultdict(list)
    for i in instructions:
        functions[i.function].append(i)
    starts = {members[0].address: name for name, members in functions.items()}
    for members in functions.values():
        flow = successors(members, following)
        mark_loops(members, flow, by_address)
    called = callers(instructions, starts)
    parts = {}  # of functions: the parts that call them

    def part_of(i):
        if i.part:
            return {i.part}
        inlined = next((part for part, name in INLINED if i.is_inlined_from(name)), None)
        return {inlined} if inlined else parts.get(i.function, set())

    # Functions that nothing calls are entered from outside of the frame; RowDrawer's set-up belongs to the triangle.
    for name in functions:
        parts[name] = set() if called[name] else {"triangle"}
    changed = True
    while changed:
        changed = False
        for name in functions:
            wanted = parts[name].union(*(part_of(i) for i in called[name]))
            if wanted != parts[name]:
                parts[name], changed = wanted, True

    def label(i):
        own = part_of(i)
        part = next(iter(own)) if len(own) == 1 else f"shared {i.function}"
        target = starts.get(i.target)
        shared = target is not None and target != i.function and len(parts[target]) > 1
        return f"call {part} > {target}" if shared else part

    ranges = []
    for i in instructions:
        end = following.get(i.address, i.address + 4)
        name = label(i)
        if ranges and ranges[-1][2] == name and ranges[-1][0] + ranges[-1][1] == i.address and not name.startswith("call"):
            ranges[-1] = (ranges[-1][0], end - ranges[-1][0], name)
        else:
            ranges.append((i.address, min(end - i.address, 4), name))
    return ranges


def count_parts(counted):
    """Instructions per part, from the counts of the names that classify() gives."""
    total = Counter()
    shared = Counter()
    calls = defaultdict(Counter)
    for name, count in counted.items():
        if name.startswith("call "):
            part, target = name[5:].split(" > ", 1)
            calls[target][part] += count
            name = part
        if name.startswith("shared "):
            shared[name[7:]] += count
        else:
            total[name] += count

    def divide(function, count, depth=0):
        """Adds `count` to the parts that call a shared function, in proportion to their calls."""
        every = sum(calls[function].values())
        if every == 0 or depth > 4:
            total["triangle"] += count
            return
        for part, times in calls[function].items():
            if part.startswith("shared "):
                divide(part[7:], count * times / every, depth + 1)
            else:
                total[part] += count * times / every

    for function, count in shared.items():
        divide(function, count)
    return {part: round(total[part]) for part in PARTS}
