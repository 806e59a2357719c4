/* The cyclic redundancy check CRC-32 (ISO/IEC 3309, as in zip and PNG): finds every change of up to
 * 32 bits in a row, so every changed byte.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_CHECKSUM_H
#define ASPERITY_DEM_CHECKSUM_H

#include <stddef.h>
#include <stdint.h>

namespace asperity {

uint32_t checksum(const void *bytes, size_t length);

} // namespace asperity

#endif
