/* The cyclic redundancy check; see checksum.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/checksum.h"

#include <array>

using namespace asperity;

/* The remainder of each byte. */
static std::array<uint32_t, 256> make_table() {
  const uint32_t polynomial = 0xEDB88320; /* its bits in reverse */
  std::array<uint32_t, 256> table;
  for (uint32_t i = 0; i < table.size(); i++) {
    table[i] = i;
    for (int bit = 0; bit < 8; bit++)
      table[i] = table[i] >> 1 ^ (table[i] & 1 ? polynomial : 0);
  }
  return table;
}

uint32_t asperity::checksum(const void *bytes, size_t length) {
  static const std::array<uint32_t, 256> table = make_table();
  const unsigned char *at = static_cast<const unsigned char *>(bytes);
  uint32_t sum = 0xFFFFFFFF;
  for (size_t i = 0; i < length; i++)
    sum = sum >> 8 ^ table[(sum ^ at[i]) & 0xFF];
  return ~sum;
}
