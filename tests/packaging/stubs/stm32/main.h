// SPDX-License-Identifier: MIT
// The public signatures of ST's HAL, as a project of CubeMX includes them, that examples/stm32 uses: the
// older ones, without const and with pointers to words, which newer ones accept. tests/examples/stm32
// implements what it runs.
// Compared with stm32f4xx_hal_spi.h and stm32f7xx_hal_ltdc.h of CubeMX projects and core_cm7.h; not with
// other families.
#pragma once
#include <stdint.h>

#define __DCACHE_PRESENT 1
#define HAL_MAX_DELAY 0xFFFFFFFFU
#define HAL_SPI_ERROR_NONE 0U
#define LTDC_RELOAD_VERTICAL_BLANKING 2U

extern "C" {
typedef enum { HAL_OK, HAL_ERROR, HAL_BUSY, HAL_TIMEOUT } HAL_StatusTypeDef;
typedef enum { HAL_SPI_STATE_RESET, HAL_SPI_STATE_READY, HAL_SPI_STATE_BUSY } HAL_SPI_StateTypeDef;
typedef struct __SPI_HandleTypeDef {
  void* Instance;
} SPI_HandleTypeDef;
typedef struct {
  void* Instance;
} LTDC_HandleTypeDef;
typedef struct {
  volatile uint32_t ODR;
} GPIO_TypeDef;
typedef enum { GPIO_PIN_RESET, GPIO_PIN_SET } GPIO_PinState;

HAL_StatusTypeDef HAL_SPI_Transmit(SPI_HandleTypeDef* hspi, uint8_t* pData, uint16_t Size, uint32_t Timeout);
HAL_StatusTypeDef HAL_SPI_Transmit_DMA(SPI_HandleTypeDef* hspi, uint8_t* pData, uint16_t Size);
HAL_StatusTypeDef HAL_SPI_Abort(SPI_HandleTypeDef* hspi);
HAL_SPI_StateTypeDef HAL_SPI_GetState(SPI_HandleTypeDef* hspi);
uint32_t HAL_SPI_GetError(SPI_HandleTypeDef* hspi);
void HAL_GPIO_WritePin(GPIO_TypeDef* GPIOx, uint16_t GPIO_Pin, GPIO_PinState PinState);
uint32_t HAL_GetTick(void);
void HAL_Delay(uint32_t Delay);
HAL_StatusTypeDef HAL_LTDC_SetAddress_NoReload(LTDC_HandleTypeDef* hltdc, uint32_t Address,
                                               uint32_t LayerIdx);
HAL_StatusTypeDef HAL_LTDC_Reload(LTDC_HandleTypeDef* hltdc, uint32_t ReloadType);
void HAL_LTDC_ReloadEventCallback(LTDC_HandleTypeDef* hltdc);
void SCB_CleanDCache_by_Addr(uint32_t* addr, int32_t dsize);
void Error_Handler(void);

typedef struct {
  volatile uint32_t CTRL, LOAD, VAL;
} SysTick_Type;
extern SysTick_Type systick_stub;
#define SysTick (&systick_stub)

extern GPIO_TypeDef port_stub;
#define LCD_DC_GPIO_Port (&port_stub)
#define LCD_RESET_GPIO_Port (&port_stub)
#define LCD_CS_GPIO_Port (&port_stub)
#define LCD_DC_Pin ((uint16_t)1)
#define LCD_RESET_Pin ((uint16_t)2)
#define LCD_CS_Pin ((uint16_t)4)
}
