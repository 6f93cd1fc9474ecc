// SPDX-License-Identifier: MIT
// The public signatures of Pico SDK 2 that examples/pico uses. Nothing is implemented. Compared with spi.h,
// dma.h and multicore.h of 1.x and gpio.h of 2.
#pragma once
#include <stddef.h>
#include <stdint.h>

extern "C" {
typedef unsigned int uint;
typedef volatile uint32_t io_rw_32;

void gpio_init(uint gpio);
void gpio_set_dir(uint gpio, bool out);
void gpio_put(uint gpio, bool value);
enum gpio_function { GPIO_FUNC_SPI = 1, GPIO_FUNC_SIO = 5 };
typedef enum gpio_function gpio_function_t;
void gpio_set_function(uint gpio, gpio_function_t fn);
#define GPIO_OUT 1

typedef struct spi_inst spi_inst_t;
typedef struct {
  io_rw_32 cr0, cr1, dr;
} spi_hw_t;
extern spi_inst_t* const spi0_stub;
#define spi0 (spi0_stub)
typedef enum { SPI_CPHA_0, SPI_CPHA_1 } spi_cpha_t;
typedef enum { SPI_CPOL_0, SPI_CPOL_1 } spi_cpol_t;
typedef enum { SPI_LSB_FIRST, SPI_MSB_FIRST } spi_order_t;
uint spi_init(spi_inst_t* spi, uint baudrate);
void spi_set_format(spi_inst_t* spi, uint data_bits, spi_cpol_t cpol, spi_cpha_t cpha, spi_order_t order);
int spi_write_blocking(spi_inst_t* spi, const uint8_t* src, size_t len);
bool spi_is_busy(const spi_inst_t* spi);
spi_hw_t* spi_get_hw(spi_inst_t* spi);
uint spi_get_dreq(spi_inst_t* spi, bool is_tx);

enum dma_channel_transfer_size { DMA_SIZE_8, DMA_SIZE_16, DMA_SIZE_32 };
typedef struct {
  uint32_t ctrl;
} dma_channel_config;
int dma_claim_unused_channel(bool required);
dma_channel_config dma_channel_get_default_config(uint channel);
void channel_config_set_transfer_data_size(dma_channel_config* c, enum dma_channel_transfer_size size);
void channel_config_set_dreq(dma_channel_config* c, uint dreq);
void dma_channel_configure(uint channel, const dma_channel_config* config, volatile void* write_addr,
                           const volatile void* read_addr, uint transfer_count, bool trigger);
bool dma_channel_is_busy(uint channel);
void dma_channel_abort(uint channel);

void multicore_launch_core1(void (*entry)(void));
void multicore_fifo_push_blocking(uint32_t data);
uint32_t multicore_fifo_pop_blocking(void);
uint32_t time_us_32(void);
void sleep_us(uint64_t us);
void panic(const char* fmt, ...) __attribute__((noreturn));
}
