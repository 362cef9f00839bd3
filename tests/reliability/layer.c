/* A layer between a program and its files, loaded with LD_PRELOAD (Linux).
 *
 * Counts the file calls that concern the folder LAYER_ROOT, and
 *  - writes a journal of them, with all data, to LAYER_JOURNAL, from which the state of the disk after a power cut is
 *    reconstructed;
 *  - lets call number LAYER_FAIL fail with the error number LAYER_ERROR, and every later one that writes, if LAYER_FOREVER is set
 *    (a disk that is full stays full);
 *  - kills the process with SIGKILL before call number LAYER_KILL. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static long handle_of[65536], handles, calls, fail_at, kill_at, error_number;
static int journal = -1, forever, ready;
static char root[PATH_MAX];
static size_t root_length;

static long number(const char *name) {
    const char *text = getenv(name);
    return text ? atol(text) : 0;
}

static void begin(void) {
    if (ready) return;
    ready = 1;
    const char *folder = getenv("LAYER_ROOT"), *path = getenv("LAYER_JOURNAL");
    if (folder) snprintf(root, sizeof root, "%s/", folder);
    root_length = strlen(root);
    fail_at = number("LAYER_FAIL");
    kill_at = number("LAYER_KILL");
    error_number = number("LAYER_ERROR");
    forever = getenv("LAYER_FOREVER") != NULL;
    if (path) journal = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
}

static char buffer[1 << 16];
static size_t filled;

static void flush(void) {
    for (size_t done = 0; done < filled;) {
        long n = syscall(SYS_write, journal, buffer + done, filled - done);
        if (n <= 0) abort();
        done += n;
    }
    filled = 0;
}

static void put(const char *text, size_t length) {
    if (journal < 0) return;
    if (filled + length > sizeof buffer) flush();
    memcpy(buffer + filled, text, length);
    filled += length;
}

static void note(const char *format, ...) {
    char line[2 * PATH_MAX + 256];
    va_list values;
    va_start(values, format);
    int length = vsnprintf(line, sizeof line, format, values);
    va_end(values);
    put(line, length);
}

/* The path below the root, or NULL for one that does not concern us. */
static const char *below(int folder, const char *path, char *place) {
    if (!root_length || !path) return NULL;
    char base[PATH_MAX] = "";
    if (path[0] != '/') {
        if (folder == AT_FDCWD) {
            if (syscall(SYS_getcwd, base, sizeof base) < 0) return NULL;
        } else {
            char link[64];
            snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
            long n = syscall(SYS_readlinkat, AT_FDCWD, link, base, sizeof base - 1);
            if (n < 0) return NULL;
            base[n] = 0;
        }
    }
    if (strlen(base) + strlen(path) + 2 > PATH_MAX) return NULL;
    strcat(strcat(strcpy(place, base), base[0] ? "/" : ""), path);
    /* Removes `.` and doubled slashes. */
    char *to = place;
    for (char *from = place; *from;) {
        if (from[0] == '/' && (from[1] == '/' || (from[1] == '.' && (from[2] == '/' || !from[2])))) from += from[1] == '/' ? 1 : 2;
        else *to++ = *from++;
    }
    *to = 0;
    /* The folder itself has an empty name. */
    size_t length = to - place;
    if (length + 1 == root_length && strncmp(place, root, length) == 0) return "";
    return strncmp(place, root, root_length) == 0 ? place + root_length : NULL;
}

/* Counts a call that concerns us; returns whether it is to fail. The lock is held until `leave`. */
static int enter(int writes) {
    calls++;
    if (kill_at && calls == kill_at) kill(getpid(), SIGKILL);
    if (fail_at && (calls == fail_at || (forever && writes && calls > fail_at))) {
        errno = error_number;
        return 1;
    }
    return 0;
}

#define REAL(result, name, ...)                                             \
    static result (*real)(__VA_ARGS__);                                     \
    if (!real) real = dlsym(RTLD_NEXT, name);                               \
    pthread_mutex_lock(&lock);                                              \
    begin()
#define LEAVE(value)                                                        \
    do {                                                                    \
        int kept = errno;                                                   \
        pthread_mutex_unlock(&lock);                                        \
        errno = kept;                                                       \
        return value;                                                       \
    } while (0)

static int opened(int folder, const char *path, int flags, mode_t mode) {
    char place[PATH_MAX];
    const char *name = below(folder, path, place);
    int writes = (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC));
    if (name && enter(writes)) return -1;
    int fd = syscall(SYS_openat, folder, path, flags, mode);
    if (fd >= 0 && fd < 65536) {
        handle_of[fd] = 0;
        if (name) {
            handle_of[fd] = ++handles;
            note("open\t%ld\t%s\t%d\t%d\n", handles, name, !!(flags & O_CREAT), !!(flags & O_TRUNC));
        }
    }
    return fd;
}

#define OPEN(name, folder, ...)                                             \
    int name(__VA_ARGS__, int flags, ...) {                                 \
        va_list values;                                                     \
        va_start(values, flags);                                            \
        mode_t mode = flags & O_CREAT ? va_arg(values, int) : 0;            \
        va_end(values);                                                     \
        pthread_mutex_lock(&lock);                                          \
        begin();                                                            \
        int fd = opened(folder, path, flags, mode);                         \
        LEAVE(fd);                                                          \
    }
OPEN(open, AT_FDCWD, const char *path)
OPEN(open64, AT_FDCWD, const char *path)
OPEN(openat, folder, int folder, const char *path)
OPEN(openat64, folder, int folder, const char *path)

static long handle(int fd) { return fd >= 0 && fd < 65536 ? handle_of[fd] : 0; }

int close(int fd) {
    REAL(int, "close", int);
    if (fd >= 0 && fd < 65536) handle_of[fd] = 0;
    int done = real(fd);
    LEAVE(done);
}

ssize_t read(int fd, void *to, size_t length) {
    REAL(ssize_t, "read", int, void *, size_t);
    ssize_t done = handle(fd) && enter(0) ? -1 : real(fd, to, length);
    LEAVE(done);
}

ssize_t write(int fd, const void *from, size_t length) {
    REAL(ssize_t, "write", int, const void *, size_t);
    if (!handle(fd)) LEAVE(real(fd, from, length));
    if (enter(1)) LEAVE(-1);
    long at = fcntl(fd, F_GETFL) & O_APPEND ? lseek(fd, 0, SEEK_END) : lseek(fd, 0, SEEK_CUR);
    ssize_t done = real(fd, from, length);
    if (done > 0 && journal >= 0) {
        note("write\t%ld\t%ld\t", handle(fd), at);
        const unsigned char *bytes = from;
        char digits[2];
        for (ssize_t k = 0; k < done; k++) {
            for (int d = 0; d < 2; d++) digits[d] = "0123456789abcdef"[bytes[k] >> (4 - 4 * d) & 15];
            put(digits, 2);
        }
        put("\n", 1);
    }
    LEAVE(done);
}

/* What a program might use instead of `write`: not supported, so that it falls back to `write`. */
ssize_t copy_file_range(int a, off64_t *b, int c, off64_t *d, size_t e, unsigned f) {
    (void)a, (void)b, (void)c, (void)d, (void)e, (void)f;
    errno = ENOSYS;
    return -1;
}
ssize_t sendfile64(int a, int b, off64_t *c, size_t d) {
    (void)a, (void)b, (void)c, (void)d;
    errno = ENOSYS;
    return -1;
}
ssize_t writev(int fd, const struct iovec *parts, int count) {
    static ssize_t (*real)(int, const struct iovec *, int);
    if (!real) real = dlsym(RTLD_NEXT, "writev");
    if (!handle(fd)) return real(fd, parts, count);
    return count > 0 ? write(fd, parts[0].iov_base, parts[0].iov_len) : 0;
}

#define SYNC(name)                                                          \
    int name(int fd) {                                                      \
        REAL(int, #name, int);                                              \
        if (!handle(fd)) LEAVE(real(fd));                                   \
        int done = enter(1) ? -1 : 0;                                       \
        if (!done) note("sync\t%ld\n", handle(fd));                         \
        LEAVE(done);                                                        \
    }
SYNC(fsync)
SYNC(fdatasync)

#define TRUNCATE(name)                                                      \
    int name(int fd, off_t length) {                                        \
        REAL(int, #name, int, off_t);                                       \
        int done = handle(fd) && enter(1) ? -1 : real(fd, length);          \
        if (!done && handle(fd)) note("length\t%ld\t%ld\n", handle(fd), (long)length); \
        LEAVE(done);                                                        \
    }
TRUNCATE(ftruncate)
TRUNCATE(ftruncate64)

int rename(const char *from, const char *to) {
    REAL(int, "rename", const char *, const char *);
    char a[PATH_MAX], b[PATH_MAX];
    const char *old = below(AT_FDCWD, from, a), *new = below(AT_FDCWD, to, b);
    int ours = old || new, done = ours && enter(1) ? -1 : real(from, to);
    if (!done && old && new) note("rename\t%s\t%s\n", old, new);
    LEAVE(done);
}

static int removed(int folder, const char *path, int flags) {
    char place[PATH_MAX];
    const char *name = below(folder, path, place);
    int done = name && enter(1) ? -1 : (int)syscall(SYS_unlinkat, folder, path, flags);
    if (!done && name) note("remove\t%s\n", name);
    return done;
}
#define REMOVE(name, parameters, folder, flags)                             \
    int name parameters {                                                   \
        pthread_mutex_lock(&lock);                                          \
        begin();                                                            \
        int done = removed(folder, path, flags);                            \
        LEAVE(done);                                                        \
    }
REMOVE(unlink, (const char *path), AT_FDCWD, 0)
REMOVE(rmdir, (const char *path), AT_FDCWD, AT_REMOVEDIR)
REMOVE(unlinkat, (int folder, const char *path, int flags), folder, flags)

int mkdir(const char *path, mode_t mode) {
    REAL(int, "mkdir", const char *, mode_t);
    char place[PATH_MAX];
    const char *name = below(AT_FDCWD, path, place);
    int done = name && enter(1) ? -1 : real(path, mode);
    if (!done && name) note("folder\t%s\n", name);
    LEAVE(done);
}

/* Tells the number of calls. */
__attribute__((destructor)) static void end(void) {
    note("calls\t%ld\n", calls);
    if (journal >= 0) flush();
}
