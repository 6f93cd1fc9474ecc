// SPDX-License-Identifier: MIT
// The public signatures of ESP-IDF that examples/esp-idf uses, of version 5.1 or 6.0. Nothing is implemented.
// Compared with headers of esp_lcd at commits 7283e349, 5f44d038 and 5595ab27, spi_common.h at 3ca37f9a and
// the guide for migration to 6.0; not FreeRTOS.
#pragma once
#ifndef IDF_VERSION
#define IDF_VERSION 51
#endif
#include <stddef.h>
#include <stdint.h>

extern "C" {
typedef int esp_err_t;
#define ESP_OK 0
void abort(void);
#define ESP_ERROR_CHECK(x) ((x) == ESP_OK ? (void)0 : abort())
void esp_log_error(const char* tag, const char* format, ...) __attribute__((format(printf, 2, 3)));
#define ESP_LOGE(tag, ...) esp_log_error(tag, __VA_ARGS__)

typedef enum { GPIO_NUM_NC = -1, GPIO_NUM_0, GPIO_NUM_MAX = 49 } gpio_num_t;
typedef enum { SPI1_HOST, SPI2_HOST, SPI3_HOST } spi_host_device_t;
typedef enum { SPI_DMA_DISABLED, SPI_DMA_CH_AUTO = 3 } spi_common_dma_t;
typedef int spi_dma_chan_t;  // in C++
typedef struct {
  union {
    int mosi_io_num;
    int data0_io_num;
  };
  union {
    int miso_io_num;
    int data1_io_num;
  };
  int sclk_io_num;
  union {
    int quadwp_io_num;
    int data2_io_num;
  };
  union {
    int quadhd_io_num;
    int data3_io_num;
  };
  int max_transfer_sz;
  uint32_t flags;
  int intr_flags;
} spi_bus_config_t;
esp_err_t spi_bus_initialize(spi_host_device_t host_id, const spi_bus_config_t* bus_config,
                             spi_dma_chan_t dma_chan);

typedef struct esp_lcd_panel_io_t* esp_lcd_panel_io_handle_t;
typedef struct esp_lcd_panel_t* esp_lcd_panel_handle_t;
#if IDF_VERSION >= 60
typedef gpio_num_t lcd_gpio;
typedef int esp_lcd_spi_bus_handle_t;  // since 5.3
#else
typedef int lcd_gpio;
typedef void* esp_lcd_spi_bus_handle_t;
#endif
typedef struct {
} esp_lcd_panel_io_event_data_t;
typedef bool (*esp_lcd_panel_io_color_trans_done_cb_t)(esp_lcd_panel_io_handle_t panel_io,
                                                       esp_lcd_panel_io_event_data_t* edata, void* user_ctx);
typedef struct {
  lcd_gpio cs_gpio_num;
  lcd_gpio dc_gpio_num;
  int spi_mode;
  unsigned int pclk_hz;
  size_t trans_queue_depth;
  esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
  void* user_ctx;
  int lcd_cmd_bits;
  int lcd_param_bits;
} esp_lcd_panel_io_spi_config_t;
esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus,
                                   const esp_lcd_panel_io_spi_config_t* io_config,
                                   esp_lcd_panel_io_handle_t* ret_io);
typedef enum { LCD_RGB_ELEMENT_ORDER_RGB, LCD_RGB_ELEMENT_ORDER_BGR } lcd_rgb_element_order_t;
typedef struct {
  lcd_gpio reset_gpio_num;
  lcd_rgb_element_order_t rgb_ele_order;
  uint32_t bits_per_pixel;
  void* vendor_config;
} esp_lcd_panel_dev_config_t;
esp_err_t esp_lcd_new_panel_st7789(const esp_lcd_panel_io_handle_t io,
                                   const esp_lcd_panel_dev_config_t* panel_dev_config,
                                   esp_lcd_panel_handle_t* ret_panel);
esp_err_t esp_lcd_panel_reset(esp_lcd_panel_handle_t panel);
esp_err_t esp_lcd_panel_init(esp_lcd_panel_handle_t panel);
esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end,
                                    int y_end, const void* color_data);
esp_err_t esp_lcd_panel_invert_color(esp_lcd_panel_handle_t panel, bool invert_color_data);
esp_err_t esp_lcd_panel_disp_on_off(esp_lcd_panel_handle_t panel, bool on_off);

typedef int BaseType_t;
typedef unsigned int UBaseType_t;
typedef uint32_t TickType_t;
#define pdFALSE ((BaseType_t)0)
#define pdTRUE ((BaseType_t)1)
#define portMAX_DELAY (TickType_t)0xffffffffUL
typedef struct QueueDefinition* QueueHandle_t;
typedef QueueHandle_t SemaphoreHandle_t;
QueueHandle_t xQueueCreateCountingSemaphore(const UBaseType_t uxMaxCount, const UBaseType_t uxInitialCount);
BaseType_t xQueueSemaphoreTake(QueueHandle_t xQueue, TickType_t xTicksToWait);
BaseType_t xQueueGiveFromISR(QueueHandle_t xQueue, BaseType_t* const pxHigherPriorityTaskWoken);
#define xSemaphoreCreateCounting(most, first) xQueueCreateCountingSemaphore((most), (first))
#define xSemaphoreTake(semaphore, ticks) xQueueSemaphoreTake((semaphore), (ticks))
#define xSemaphoreGiveFromISR(semaphore, woken) xQueueGiveFromISR((semaphore), (woken))
}
