// SPDX-License-Identifier: MIT
// Kernel module of the test guest: an SPI controller with one spidev, and an I2C adapter with one device.
// Both keep what was sent to them, for a test to compare, and fail where they are told to. Files in debugfs,
// "arcspan/":
//   spi_log      16-bit words, one for each byte: the level of the D/C line << 8 | the byte
//   i2c_log      16-bit words: 0x100 | address at a start, the bytes, 0x200 at a stop
//   clear        write: empties both logs and takes back what was injected
//   spi_fail_at, spi_short_at   write n: the transfer that holds the n-th byte from now on fails, or ends
//   before it; once i2c_error    write n: transactions end with the error -n
#include <linux/debugfs.h>
#include <linux/gpio.h>
#include <linux/gpio/consumer.h>
#include <linux/i2c.h>
#include <linux/module.h>
#include <linux/platform_device.h>
#include <linux/spi/spi.h>
#include <linux/vmalloc.h>

#define LOG_WORDS (4u << 20)
#define NEVER (-1ll)
#define I2C_ADDRESS 0x3c

static int dc_line = -1;
module_param(dc_line, int, 0444);
MODULE_PARM_DESC(dc_line, "the kernel's number of the D/C line");

struct word_log {
  u16* words;
  unsigned long count;
  struct debugfs_blob_wrapper blob;
};

static struct word_log spi_log, i2c_log;
static s64 spi_fail_at = NEVER, spi_short_at = NEVER;
static int i2c_error;
static struct platform_device* host;
static struct spi_controller* controller;
static struct i2c_adapter adapter;
static struct dentry* folder;

static void log_word(struct word_log* log, u16 word) {
  if (log->count < LOG_WORDS) log->words[log->count++] = word;
  log->blob.size = log->count * sizeof(u16);
}

static int log_init(struct word_log* log) {
  log->words = vzalloc(LOG_WORDS * sizeof(u16));
  log->blob.data = log->words;
  return log->words ? 0 : -ENOMEM;
}

// The number of bytes of `transfer` that get through; a negative error if it is to fail.
static int spi_bytes(const struct spi_transfer* transfer, u16 level) {
  const u8* bytes = transfer->tx_buf;
  unsigned int i;

  for (i = 0; bytes && i < transfer->len; i++) {
    if (spi_fail_at == (s64)spi_log.count) {
      spi_fail_at = NEVER;
      return -EIO;
    }
    if (spi_short_at == (s64)spi_log.count) {
      spi_short_at = NEVER;
      return i;
    }
    log_word(&spi_log, level << 8 | bytes[i]);
  }
  return transfer->len;
}

static int spi_message(struct spi_controller* c, struct spi_message* message) {
  struct gpio_desc* dc = dc_line >= 0 ? gpio_to_desc(dc_line) : NULL;
  u16 level = dc ? gpiod_get_raw_value_cansleep(dc) : 0;
  struct spi_transfer* transfer;

  message->status = 0;
  message->actual_length = 0;
  list_for_each_entry(transfer, &message->transfers, transfer_list) {
    int sent = spi_bytes(transfer, level);

    if (sent < 0) {
      message->status = sent;
      break;
    }
    message->actual_length += sent;
    if (sent < (int)transfer->len) break;
  }
  spi_finalize_current_message(c);
  return 0;
}

static int i2c_transfer_all(struct i2c_adapter* a, struct i2c_msg* messages, int count) {
  int i, k;

  for (i = 0; i < count; i++) {
    if (i2c_error) return -i2c_error;
    if (messages[i].addr != I2C_ADDRESS || (messages[i].flags & I2C_M_RD)) return -ENXIO;
    log_word(&i2c_log, 0x100 | messages[i].addr);
    for (k = 0; k < messages[i].len; k++) log_word(&i2c_log, messages[i].buf[k]);
  }
  log_word(&i2c_log, 0x200);
  return count;
}

static u32 i2c_functions(struct i2c_adapter* a) { return I2C_FUNC_I2C; }

static const struct i2c_algorithm algorithm = {
    .master_xfer = i2c_transfer_all,
    .functionality = i2c_functions,
};

static int clear(void* data, u64 value) {
  spi_log.count = i2c_log.count = 0;
  spi_log.blob.size = i2c_log.blob.size = 0;
  spi_fail_at = spi_short_at = NEVER;
  i2c_error = 0;
  return 0;
}
DEFINE_DEBUGFS_ATTRIBUTE(clear_file, NULL, clear, "%llu\n");

static int set_fail(void* data, u64 value) {
  spi_fail_at = spi_log.count + value;
  return 0;
}
DEFINE_DEBUGFS_ATTRIBUTE(fail_file, NULL, set_fail, "%llu\n");

static int set_short(void* data, u64 value) {
  spi_short_at = spi_log.count + value;
  return 0;
}
DEFINE_DEBUGFS_ATTRIBUTE(short_file, NULL, set_short, "%llu\n");

static int set_i2c_error(void* data, u64 value) {
  i2c_error = (int)value;
  return 0;
}
DEFINE_DEBUGFS_ATTRIBUTE(i2c_error_file, NULL, set_i2c_error, "%llu\n");

static int add_spi(void) {
  struct spi_board_info child = {
      .modalias = "dh2228fv",  // a name that spidev binds to
      .max_speed_hz = 62500000,
      .mode = SPI_MODE_0,
  };
  int result;

  controller = spi_alloc_master(&host->dev, 0);
  if (!controller) return -ENOMEM;
  controller->bus_num = 0;
  controller->num_chipselect = 1;
  controller->mode_bits = SPI_CPHA;  // no modes 2 and 3
  controller->transfer_one_message = spi_message;
  result = spi_register_controller(controller);
  if (result) return result;
  return spi_new_device(controller, &child) ? 0 : -ENODEV;
}

static int add_i2c(void) {
  adapter.owner = THIS_MODULE;
  adapter.algo = &algorithm;
  adapter.nr = 7;
  strscpy(adapter.name, "arcspan test adapter", sizeof(adapter.name));
  return i2c_add_numbered_adapter(&adapter);
}

static int __init models_init(void) {
  if (log_init(&spi_log) || log_init(&i2c_log)) return -ENOMEM;
  host = platform_device_register_simple("arcspan-models", -1, NULL, 0);
  if (IS_ERR(host)) return PTR_ERR(host);
  folder = debugfs_create_dir("arcspan", NULL);
  debugfs_create_blob("spi_log", 0444, folder, &spi_log.blob);
  debugfs_create_blob("i2c_log", 0444, folder, &i2c_log.blob);
  debugfs_create_file("clear", 0200, folder, NULL, &clear_file);
  debugfs_create_file("spi_fail_at", 0200, folder, NULL, &fail_file);
  debugfs_create_file("spi_short_at", 0200, folder, NULL, &short_file);
  debugfs_create_file("i2c_error", 0200, folder, NULL, &i2c_error_file);
  return add_spi() ?: add_i2c();
}
// No exit: the guest is thrown away.
module_init(models_init);
MODULE_LICENSE("Dual MIT/GPL");
MODULE_DESCRIPTION("Models of an SPI and an I2C bus for tests");
