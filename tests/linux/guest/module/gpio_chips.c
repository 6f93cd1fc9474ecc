// SPDX-License-Identifier: MIT
// Kernel module of the test guest: two GPIO chips, and a third that can be plugged and unplugged. The wire of
// each line is pulled from outside, down at first; a line that no program drives has that level. Files in
// debugfs, "arcspan_gpio/":
//   line0 ... line7   of the first chip. read: the level of the line; write 1 or 0: pulls its wire up or down
//   plugged           write 1, and then 0: the third chip comes, and goes even if its lines are held
#include <linux/debugfs.h>
#include <linux/gpio/driver.h>
#include <linux/module.h>

#define MAX_LINES 8

struct line {
  bool is_output, driven, pulled;
};

struct chip {
  struct gpio_chip gpio;
  struct line lines[MAX_LINES];
};

static struct line* line_of(struct gpio_chip* gpio, unsigned int offset) {
  return &container_of(gpio, struct chip, gpio)->lines[offset];
}

static bool level(const struct line* line) { return line->is_output ? line->driven : line->pulled; }

static int get(struct gpio_chip* gpio, unsigned int offset) { return level(line_of(gpio, offset)); }

static void set(struct gpio_chip* gpio, unsigned int offset, int value) {
  line_of(gpio, offset)->driven = value != 0;
}

static int get_direction(struct gpio_chip* gpio, unsigned int offset) {
  return line_of(gpio, offset)->is_output ? GPIO_LINE_DIRECTION_OUT : GPIO_LINE_DIRECTION_IN;
}

static int direction_input(struct gpio_chip* gpio, unsigned int offset) {
  line_of(gpio, offset)->is_output = false;
  return 0;
}

static int direction_output(struct gpio_chip* gpio, unsigned int offset, int value) {
  set(gpio, offset, value);
  line_of(gpio, offset)->is_output = true;
  return 0;
}

// A line that is released is not driven any more.
static void release(struct gpio_chip* gpio, unsigned int offset) { direction_input(gpio, offset); }

static const char* const panel_names[8] = {
    [2] = "BUSY", [3] = "DC", [4] = "RESET", [5] = "BACKLIGHT", [6] = "TWICE",
};
static const char* const other_names[4] = {[0] = "TWICE"};
static const char* const plugged_names[2] = {"PLUGGED_INPUT", "PLUGGED_OUTPUT"};
static struct chip panel, other, plugged;

static int add(struct chip* chip, const char* label, const char* const* names, u16 count) {
  chip->gpio = (struct gpio_chip){
      .label = label,
      .owner = THIS_MODULE,
      .free = release,
      .get_direction = get_direction,
      .direction_input = direction_input,
      .direction_output = direction_output,
      .get = get,
      .set = set,
      .base = -1,  // the kernel chooses the numbers
      .ngpio = count,
      .names = names,
  };
  return gpiochip_add_data(&chip->gpio, chip);
}

static int line_level(void* data, u64* value) {
  *value = level(data);
  return 0;
}

static int pull_line(void* data, u64 value) {
  ((struct line*)data)->pulled = value != 0;
  return 0;
}
DEFINE_DEBUGFS_ATTRIBUTE(line_file, line_level, pull_line, "%llu\n");

static int plug(void* data, u64 value) {
  if (value) return add(&plugged, "plugged", plugged_names, ARRAY_SIZE(plugged_names));
  gpiochip_remove(&plugged.gpio);
  return 0;
}
DEFINE_DEBUGFS_ATTRIBUTE(plugged_file, NULL, plug, "%llu\n");

static int __init chips_init(void) {
  struct dentry* folder = debugfs_create_dir("arcspan_gpio", NULL);
  char name[8];
  unsigned int i;

  for (i = 0; i < ARRAY_SIZE(panel_names); i++) {
    snprintf(name, sizeof(name), "line%u", i);
    debugfs_create_file(name, 0600, folder, &panel.lines[i], &line_file);
  }
  debugfs_create_file("plugged", 0200, folder, NULL, &plugged_file);
  return add(&panel, "panel", panel_names, ARRAY_SIZE(panel_names))
             ?: add(&other, "other", other_names, ARRAY_SIZE(other_names));
}
// No exit: the guest is thrown away.
module_init(chips_init);
MODULE_LICENSE("Dual MIT/GPL");
MODULE_DESCRIPTION("GPIO chips for tests");
