/* SPDX-License-Identifier: MIT
 * A TCG plugin that counts executed instructions, in total and per address range, between marks.
 *
 * Arguments:
 *   ranges=FILE   lines "first-address size name", hexadecimal, sorted and without overlap
 *   mark=ADDRESS  address of the function that the guest calls as a mark
 *   out=FILE      report to write
 *
 * The report has, for every mark and for the end, a line "section TOTAL" with the instructions since the
 * last mark, and a line "range COUNT name" for every range that was executed. The instruction at ADDRESS
 * belongs to the section that begins there.
 */
#include "plugin_api.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct range {
  uint64_t first;
  uint64_t size;
  uint64_t count;
  char name[512];
};

int qemu_plugin_version = 1;

static struct range* ranges;
static size_t range_count;
static uint64_t total;
static uint64_t mark_address;
static FILE* report;

static int read_ranges(const char* path) {
  FILE* file = fopen(path, "r");
  struct range next = {0};
  if (file == NULL) return -1;
  while (fscanf(file, "%" SCNx64 " %" SCNx64 " %511[^\n]", &next.first, &next.size, next.name) == 3) {
    struct range* grown = realloc(ranges, (range_count + 1) * sizeof *ranges);
    if (grown == NULL) break;
    ranges = grown;
    ranges[range_count++] = next;
  }
  const int complete = feof(file);
  fclose(file);
  return complete ? 0 : -1;
}

static int compare_address(const void* key, const void* element) {
  const uint64_t address = *(const uint64_t*)key;
  const struct range* range = element;
  if (address < range->first) return -1;
  return address >= range->first + range->size;
}

static void write_section(void) {
  fprintf(report, "section %" PRIu64 "\n", total);
  for (size_t i = 0; i < range_count; ++i) {
    if (ranges[i].count != 0) fprintf(report, "range %" PRIu64 " %s\n", ranges[i].count, ranges[i].name);
    ranges[i].count = 0;
  }
  total = 0;
}

static void on_mark(unsigned int vcpu, void* user) {
  (void)vcpu;
  (void)user;
  write_section();
}

static void on_translation(qemu_plugin_id_t id, struct qemu_plugin_tb* block) {
  (void)id;
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    struct qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(block, i);
    const uint64_t address = qemu_plugin_insn_vaddr(instruction);
    struct range* range = bsearch(&address, ranges, range_count, sizeof *ranges, compare_address);
    if (address == mark_address) {
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_mark, QEMU_PLUGIN_CB_NO_REGS, NULL);
    }
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, QEMU_PLUGIN_INLINE_ADD_U64, &total, 1);
    if (range != NULL) {
      qemu_plugin_register_vcpu_insn_exec_inline(instruction, QEMU_PLUGIN_INLINE_ADD_U64, &range->count, 1);
    }
  }
}

static void on_end(qemu_plugin_id_t id, void* user) {
  (void)id;
  (void)user;
  write_section();
  fclose(report);
}

static int read_argument(const char* argument) {
  if (strncmp(argument, "ranges=", 7) == 0) return read_ranges(argument + 7);
  if (strncmp(argument, "mark=", 5) == 0) {
    mark_address = strtoull(argument + 5, NULL, 16);
    return 0;
  }
  if (strncmp(argument, "out=", 4) == 0) {
    report = fopen(argument + 4, "w");
    return report == NULL ? -1 : 0;
  }
  return -1;
}

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* info, int argc, char** argv) {
  (void)info;
  for (int i = 0; i < argc; ++i) {
    if (read_argument(argv[i]) != 0) {
      fprintf(stderr, "instruction_count: bad argument %s\n", argv[i]);
      return -1;
    }
  }
  if (report == NULL) {
    fprintf(stderr, "instruction_count: no out=FILE\n");
    return -1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
  qemu_plugin_register_atexit_cb(id, on_end, NULL);
  return 0;
}
