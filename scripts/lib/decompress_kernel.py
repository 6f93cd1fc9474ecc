# SPDX-License-Identifier: MIT
"""Makes a kernel image for QEMU in which the kernel is decompressed already. Debian's kernels decompress themselves at
each start, which takes seconds where the processor is emulated.

decompress_kernel.py amd64 VMLINUZ START RESULT    keeps the kernel's real-mode code, because it sets the display's mode;
                                                   START, assembler source, replaces the decompressor
decompress_kernel.py arm VMLINUZ RESULT            in U-Boot's image format
"""
import lzma
import pathlib
import struct
import subprocess
import sys
import tempfile

XZ_MAGIC = b"\xfd7zXZ\0\0\1"  # the start of a stream whose check is CRC32, as the kernel's is
AMD64_START = 0x100000  # where the kernel is loaded, without its real-mode code
ARM_RAM = 0x40000000  # of QEMU's board `virt`


def decompress(image):
    if XZ_MAGIC not in image:
        sys.exit("decompress_kernel.py: the kernel is not compressed by xz")
    return lzma.LZMADecompressor().decompress(image[image.index(XZ_MAGIC):])


def assemble(source, entry):
    """The code of start.s for a kernel with this entry."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["as", "-o", f"{folder}/object", source], check=True)
        subprocess.run(["ld", "-e", "0", "-Ttext", hex(AMD64_START), f"--defsym=kernel_entry={entry}", "--oformat", "binary",
                        "-o", f"{folder}/code", f"{folder}/object"], check=True)
        return pathlib.Path(f"{folder}/code").read_bytes()


def amd64(image, start):
    elf = decompress(image)
    entry, headers = struct.unpack_from("<QQ", elf, 24)
    header_size, header_count = struct.unpack_from("<HH", elf, 54)
    memory = bytearray()
    for i in range(header_count):
        kind, _, offset, _, address, in_file, in_memory, _ = struct.unpack_from("<IIQQQQQQ", elf, headers + i * header_size)
        if kind == 1:  # a segment that is loaded
            begin = address - AMD64_START
            memory.extend(bytes(max(0, begin + in_memory - len(memory))))
            memory[begin:begin + in_file] = elf[offset:offset + in_file]
    code = assemble(start, entry)
    memory[:len(code)] = code
    real_mode_size = 512 * (image[0x1F1] + 1)
    return image[:real_mode_size] + memory


def arm(image):
    kernel = decompress(image)
    table, = struct.unpack_from("<I", image, 0x38)
    text_offset, = struct.unpack_from("<I", image, table + 16)
    address = ARM_RAM + text_offset
    # Magic number, two sums and a time that QEMU does not look at; Linux, Arm, kernel, not compressed; no name.
    return struct.pack(">7I4B32s", 0x27051956, 0, 0, len(kernel), address, address, 0, 5, 2, 2, 0, b"") + kernel


def main():
    architecture, vmlinuz, *start, result = sys.argv[1:]
    make = {"amd64": amd64, "arm": arm}[architecture]
    pathlib.Path(result).write_bytes(make(pathlib.Path(vmlinuz).read_bytes(), *start))


main()
