# SPDX-License-Identifier: MIT
# Stands in place of the kernel's own decompressor in an image whose kernel is decompressed already. The kernel's real-mode
# code jumps here in 32-bit mode, with the address of the boot parameters in %esi. This code switches to 64-bit mode and
# jumps to the kernel's 64-bit entry, as Documentation/x86/boot.rst of Linux wants it.
.code32
  lgdt segment_table
  mov %cr4, %eax
  or $0x20, %eax  # PAE
  mov %eax, %cr4
  mov $pages_4, %eax
  mov %eax, %cr3
  mov $0xc0000080, %ecx  # EFER
  rdmsr
  or $0x100, %eax  # LME
  wrmsr
  mov %cr0, %eax
  or $0x80000000, %eax  # PG
  mov %eax, %cr0
  ljmp $0x10, $long_mode
.code64
long_mode:
  mov %esi, %esi  # clears the upper half
  mov $kernel_entry, %eax
  jmp *%rax

.balign 8
segments:
  .quad 0, 0, 0x00af9a000000ffff, 0x00cf92000000ffff  # code at 0x10, data at 0x18
segment_table:
  .word . - segments - 1
  .long segments

# The first gigabyte at its own addresses, in pages of 2 MB.
.balign 4096
pages_4:
  .quad pages_3 + 3  # present, writable
.balign 4096
pages_3:
  .quad pages_2 + 3
.balign 4096
pages_2:
  .set address, 0
  .rept 512
  .quad address + 0x83  # and a large page
  .set address, address + 0x200000
  .endr
