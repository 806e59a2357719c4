/* The file of a ledger, on the one rank that writes it. A run begins it; a restart continues it.
 * Rows are added when a window of rows ends. If a write fails, the file is cut back to the last row
 * before the window.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_LEDGER_FILE_H
#define ASPERITY_DEM_LEDGER_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <string>
#include <vector>

namespace asperity {

/* FNV-1a: changes with every byte. */
uint32_t checksum(const void *bytes, size_t length);

/* State of a ledger's file in a restart file: enough to recognize the file and cut it back. */
struct LedgerState {
  std::string path; /* as the script has it; empty: there is nothing to continue */
  int64_t rows, bytes;
  uint32_t tail; /* checksum of the last rows */
};

class LedgerFile {
public:
  /* columns: see ledger_row.h. */
  LedgerFile(const std::string &path, int columns);
  ~LedgerFile();
  LedgerFile(const LedgerFile &) = delete;
  LedgerFile &operator=(const LedgerFile &) = delete;

  /* Continues the file if `saved`, of a restart file, describes it; begins it anew otherwise.
   * Throws an Error if it is not a regular file, cannot be written or continued, or is locked by
   * another wall or run. Returns a note for the user, or an empty string. */
  std::string open(const LedgerState &saved, const std::string &heading);

  bool is_open() const {
    return fd_ >= 0;
  }

  /* Rows as the file has them. */
  void append(const char *bytes, size_t length);

  /* The end of a window with that many rows: they are all in the file, or none. Returns an empty
   * string, or why they are not. */
  std::string commit(int64_t rows);

  /* Waits until the disk has all of it. Returns an empty string, or why it has not. */
  std::string sync();

  LedgerState state() const;

private:
  bool open_or_create(const LedgerState &saved);
  void lock();
  void begin(const std::string &heading);
  std::string begin_or_continue(bool is_new, const LedgerState &saved, const std::string &heading);
  std::string continue_at(const LedgerState &state);
  void check_columns();
  bool holds(const LedgerState &state) const;
  uint32_t tail_at(int64_t bytes) const;
  int64_t size() const;
  int64_t count_rows(int64_t from, bool &torn) const;

  void write(const char *bytes, size_t length, int64_t at);
  void write_buffer();
  void take_back();
  bool is_deleted() const;

  std::string path_;
  int columns_;
  int fd_;
  int64_t rows_, bytes_; /* of the windows that have ended */
  int64_t pending_;      /* bytes of this window that have been written */
  bool torn_;            /* there may be more than bytes_ in the file */
  std::string why_;      /* what has gone wrong in this window */
  std::vector<char> buffer_;
};

} // namespace asperity

#endif
