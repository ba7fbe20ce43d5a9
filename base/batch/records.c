/* Files of points: appended, checksummed, read back up to what was written whole. */
#include "base/batch/records.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/batch/record_file_impl.h"
#include "base/batch/records_impl.h"
#include "base/core/file.h"

#define MAGIC          "UMBATCH1"
#define ORDER          0x0102030405060708u
#define RECORD         0x544e4f50u /* "PONT" */
#define HEAD           8           /* of a record: RECORD and the length of its reason [byte] */
#define CRC            4           /* [byte] */
#define REASON_LONGEST 4096        /* [byte] */

struct header {
  char magic[8];
  uint64_t order, identity, ncoordinate, nvalue;
  uint32_t crc, nothing;
};

struct um_batch_records {
  struct header header;
  size_t nfile; /* the first one is this process's own */
  struct um_batch_file *file;
  uint64_t length; /* of the own file, all records whole [byte] */
  bool unsynced;
  unsigned char *buffer; /* [room] one record */
  size_t room;
};

static size_t payload(const struct um_batch_records *r, uint32_t reason)
{
  return reason > 0 ? reason : (size_t)r->header.nvalue * sizeof(double);
}

/* The record at offset into the buffer; false: none that is whole. */
static bool read_record(const struct um_batch_records *r, int descriptor, uint64_t offset,
                        uint32_t *reason, size_t *bytes)
{
  uint32_t head[2], crc;
  if (um_batch_file_read(descriptor, offset, r->buffer, HEAD) != HEAD) return false;
  memcpy(head, r->buffer, HEAD);
  if (head[0] != RECORD || head[1] > REASON_LONGEST) return false;
  *reason = head[1];
  *bytes = HEAD + (size_t)r->header.ncoordinate * sizeof(double) + payload(r, head[1]);
  if (um_batch_file_read(descriptor, offset + HEAD, r->buffer + HEAD, *bytes - HEAD + CRC) !=
      *bytes - HEAD + CRC)
    return false;
  memcpy(&crc, r->buffer + *bytes, CRC);
  return crc == um_batch_file_checksum(r->buffer, *bytes);
}

/* Every whole record of a file; *length: where the last one ends. */
static enum um_status scan(struct um_context *context, struct um_batch_records *r, size_t file,
                           um_batch_found *found, void *self, uint64_t *length, size_t *count)
{
  uint32_t reason;
  size_t bytes, at = HEAD + (size_t)r->header.ncoordinate * sizeof(double);
  for (;;) {
    UM_TRY(um_core_stop_check(context, "points on record were read"));
    if (!read_record(r, r->file[file].descriptor, *length, &reason, &bytes)) return UM_OK;
    struct um_batch_place place = {file, *length + at, reason};
    double *coordinate =
        (double *)(void *)(r->buffer + HEAD); /* the buffer is aligned, HEAD is 8 */
    if (found != NULL) UM_TRY(found(context, self, coordinate, place));
    *length += bytes + CRC;
    (*count)++;
  }
}

/* Is there a header, and of what? */
static enum um_status check_header(struct um_context *context, const struct um_batch_records *r,
                                   const struct um_batch_file *file, bool *there)
{
  struct header h;
  size_t n = um_batch_file_read(file->descriptor, 0, &h, sizeof h);
  *there = false;
  if (n == SIZE_MAX) return um_batch_file_fail(context, file->path, "cannot be read");
  if (n < sizeof h) return UM_OK;
  if (memcmp(h.magic, MAGIC, sizeof h.magic) != 0 || h.order != ORDER ||
      h.crc != um_batch_file_checksum(&h, offsetof(struct header, crc)))
    return um_core_fail(context, UM_ERR_IO,
                        "%s: is not a file of records of this kind of machine; accepted: another "
                        "folder, or one without it",
                        file->path);
  if (memcmp(&h, &r->header, sizeof h) != 0)
    return um_core_fail(context, UM_ERR_IO,
                        "%s: holds points of other work: its input, its options or the version of "
                        "Umbra were others; accepted: another folder, or one without it",
                        file->path);
  *there = true;
  return UM_OK;
}

static enum um_status add_file(struct um_context *context, struct um_batch_records *r,
                               const char *folder, const char *name, int flags)
{
  UM_TRY(um_core_reallocate(context, r->nfile + 1, sizeof *r->file, &r->file));
  struct um_batch_file *file = &r->file[r->nfile];
  *file = (struct um_batch_file){.descriptor = -1};
  UM_TRY(um_core_asprintf(context, &file->path, "%s/%s", folder, name));
  r->nfile++;
  return um_core_descriptor_open(context, file->path, flags, &file->descriptor);
}

/* This process's file: locked, its whole records kept, made where it is new. */
static enum um_status open_own(struct um_context *context, const struct um_batch_task *task,
                               const char *name, um_batch_found *found, void *self,
                               struct um_batch_records *r)
{
  bool there;
  size_t count = 0;
  struct stat st;
  UM_TRY(add_file(context, r, task->folder, name, O_RDWR | O_CREAT));
  const struct um_batch_file *file = &r->file[0];
  UM_TRY(um_batch_file_lock(context, file));
  enum um_status status = check_header(context, r, file, &there);
  if (status != UM_OK && task->resume) return status;
  if (status != UM_OK || there) {
    r->length = sizeof r->header;
    if (status == UM_OK) UM_TRY(scan(context, r, 0, found, self, &r->length, &count));
    if (!task->resume && (status != UM_OK || count > 0)) {
      um_core_message_clear(context);
      return um_core_fail(context, UM_ERR_IO,
                          "%s: points are on record there; accepted: to resume, or another folder",
                          file->path);
    }
    if (fstat(file->descriptor, &st) != 0)
      return um_batch_file_fail(context, file->path, "cannot be read");
    if ((uint64_t)st.st_size > r->length) {
      um_core_log(context, UM_LOG_WARNING,
                  "%s: the last %llu bytes are no whole record and are cut off; %zu points before "
                  "them are kept",
                  file->path, (unsigned long long)st.st_size - (unsigned long long)r->length,
                  count);
      if (ftruncate(file->descriptor, (off_t)r->length) != 0)
        return um_batch_file_fail(context, file->path, "cannot be cut");
    }
    return UM_OK;
  }
  r->length = sizeof r->header;
  r->unsynced = true;
  if (ftruncate(file->descriptor, 0) != 0 ||
      !um_batch_file_write(file->descriptor, 0, &r->header, sizeof r->header))
    return um_batch_file_fail(context, file->path, "cannot be written");
  um_batch_file_folder_sync(task->folder);
  return um_batch_records_sync(context, r);
}

static bool is_records_name(const char *name)
{
  size_t n = strlen(name), tail = strlen(".records");
  return strncmp(name, "points", 6) == 0 && n > tail && strcmp(name + n - tail, ".records") == 0;
}

/* Files of other shares: read as far as they are whole; their processes may be at work. */
static enum um_status open_others(struct um_context *context, const char *folder, const char *own,
                                  um_batch_found *found, void *self, struct um_batch_records *r)
{
  enum um_status status = UM_OK;
  DIR *dir = opendir(folder);
  if (dir == NULL) return um_batch_file_fail(context, folder, "cannot be read");
  for (const struct dirent *entry; status == UM_OK && (entry = readdir(dir)) != NULL;) {
    bool there = false;
    uint64_t length = sizeof r->header;
    size_t count = 0;
    if (!is_records_name(entry->d_name) || strcmp(entry->d_name, own) == 0) continue;
    status = add_file(context, r, folder, entry->d_name, O_RDONLY);
    if (status == UM_OK) status = check_header(context, r, &r->file[r->nfile - 1], &there);
    if (status == UM_OK && there)
      status = scan(context, r, r->nfile - 1, found, self, &length, &count);
  }
  closedir(dir);
  return status;
}

enum um_status um_batch_records_open(struct um_context *context, const struct um_batch_task *task,
                                     um_batch_found *found, void *self,
                                     struct um_batch_records **out)
{
  struct um_batch_records *r;
  char name[96] = "points.records";
  *out = NULL;
  if (task->nshare > 1)
    snprintf(name, sizeof name, "points-%zu-of-%zu.records", task->share + 1, task->nshare);
  UM_TRY(um_core_allocate(context, 1, sizeof *r, &r));
  r->header = (struct header){.order = ORDER,
                              .identity = task->identity,
                              .ncoordinate = task->work.ncoordinate,
                              .nvalue = task->work.nvalue};
  memcpy(r->header.magic, MAGIC, sizeof r->header.magic);
  r->header.crc = um_batch_file_checksum(&r->header, offsetof(struct header, crc));
  size_t values = task->work.nvalue * sizeof(double);
  r->room = HEAD + task->work.ncoordinate * sizeof(double) +
            (values > REASON_LONGEST ? values : REASON_LONGEST) + CRC;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, r->room, 1, &r->buffer));
  UM_CHECK(um_batch_file_folder_make(context, task->folder));
  UM_CHECK(open_own(context, task, name, found, self, r));
  UM_CHECK(open_others(context, task->folder, name, found, self, r));
  *out = r;
  r = NULL;
done:
  um_batch_records_close(context, &r);
  return status;
}

enum um_status um_batch_records_append(struct um_context *context, struct um_batch_records *r,
                                       const double *coordinate, const double *value,
                                       const char *reason, struct um_batch_place *place)
{
  size_t n = (size_t)r->header.ncoordinate * sizeof *coordinate;
  size_t length = reason == NULL ? 0 : strlen(reason);
  if (length > REASON_LONGEST) length = REASON_LONGEST;
  if (reason != NULL && length == 0) length = strlen(reason = "no reason was given");
  uint32_t head[2] = {RECORD, (uint32_t)length};
  size_t bytes = HEAD + n + payload(r, head[1]);
  memcpy(r->buffer, head, HEAD);
  memcpy(r->buffer + HEAD, coordinate, n);
  if (payload(r, head[1]) > 0)
    memcpy(r->buffer + HEAD + n, reason == NULL ? (const void *)value : reason,
           payload(r, head[1]));
  uint32_t crc = um_batch_file_checksum(r->buffer, bytes);
  memcpy(r->buffer + bytes, &crc, CRC);
  if (!um_batch_file_write(r->file[0].descriptor, r->length, r->buffer, bytes + CRC)) {
    enum um_status status = um_batch_file_fail(context, r->file[0].path, "a point cannot be kept");
    int cut = ftruncate(r->file[0].descriptor, (off_t)r->length);
    (void)cut; /* what it leaves is cut off when the file is opened again */
    return status;
  }
  *place = (struct um_batch_place){0, r->length + HEAD + n, head[1]};
  r->length += bytes + CRC;
  r->unsynced = true;
  return UM_OK;
}

enum um_status um_batch_records_sync(struct um_context *context, struct um_batch_records *r)
{
  if (!r->unsynced) return UM_OK;
  if (fdatasync(r->file[0].descriptor) != 0 && errno != EINVAL && errno != ENOTSUP)
    return um_batch_file_fail(context, r->file[0].path, "points cannot be brought to the disk");
  r->unsynced = false;
  return UM_OK;
}

static enum um_status read_place(struct um_context *context, const struct um_batch_records *r,
                                 struct um_batch_place place, void *out, size_t bytes)
{
  const struct um_batch_file *file = &r->file[place.file];
  size_t n = um_batch_file_read(file->descriptor, place.offset, out, bytes);
  if (n == bytes) return UM_OK;
  if (n != SIZE_MAX) errno = ENODATA;
  return um_batch_file_fail(context, file->path, "a point that was on record cannot be read");
}

enum um_status um_batch_records_value(struct um_context *context, const struct um_batch_records *r,
                                      struct um_batch_place place, double *value)
{
  return read_place(context, r, place, value, payload(r, 0));
}

enum um_status um_batch_records_reason(struct um_context *context, const struct um_batch_records *r,
                                       struct um_batch_place place, char **out)
{
  UM_TRY(um_core_allocate(context, (size_t)place.reason + 1, 1, out));
  enum um_status status = read_place(context, r, place, *out, place.reason);
  if (status == UM_OK) return UM_OK;
  um_core_free(context, *out);
  *out = NULL;
  return status;
}

void um_batch_records_drop(struct um_batch_records *r)
{
  for (size_t i = 0; i < r->nfile; i++) {
    if (r->file[i].descriptor >= 0) close(r->file[i].descriptor);
    r->file[i].descriptor = -1;
  }
}

void um_batch_records_close(struct um_context *context, struct um_batch_records **records)
{
  if (records == NULL || *records == NULL) return;
  um_batch_records_drop(*records);
  for (size_t i = 0; i < (*records)->nfile; i++) um_core_free(context, (*records)->file[i].path);
  um_core_free(context, (*records)->file);
  um_core_free(context, (*records)->buffer);
  um_core_free(context, *records);
  *records = NULL;
}

void um_batch_records_remove(struct um_context *context, const char *folder)
{
  DIR *dir = opendir(folder);
  if (dir == NULL) return;
  for (const struct dirent *entry; (entry = readdir(dir)) != NULL;) {
    char *path;
    if (!is_records_name(entry->d_name)) continue;
    if (um_core_asprintf(context, &path, "%s/%s", folder, entry->d_name) != UM_OK) break;
    (void)unlink(path);
    um_core_free(context, path);
  }
  closedir(dir);
  (void)rmdir(folder);
}
