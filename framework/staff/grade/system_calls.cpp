#include "framework/staff/grade/system_calls.h"

#include <fmt/format.h>
#include <linux/sched.h>
#include <seccomp.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"
#include "framework/core/base/process.h"

namespace relief::grade {
namespace {

// Libraries try these, and fall back to other calls.
constexpr const char* absent[] = {"memfd_create",   "memfd_secret",   "clone3",
                                  "io_uring_setup", "io_uring_enter", "io_uring_register"};

constexpr const char* refused[] = {
    // Memory and messages that outlive their process.
    "shmget", "shmat", "shmctl", "shmdt", "semget", "semop", "semtimedop", "semctl", "msgget", "msgsnd", "msgrcv",
    "msgctl", "mq_open", "mq_unlink",
    // Other processes.
    "ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "pidfd_open", "pidfd_getfd",
    "pidfd_send_signal", "kcmp", "perf_event_open",
    // The network, and other programs on this machine.
    "socket",
    // Namespaces and mounts.
    "unshare", "setns", "chroot", "pivot_root", "mount", "umount2", "mount_setattr", "move_mount", "open_tree",
    "fsopen", "fsmount", "fsconfig", "fspick", "name_to_handle_at", "open_by_handle_at",
    // The kernel itself.
    "bpf", "userfaultfd", "add_key", "request_key", "keyctl", "fanotify_init", "init_module", "finit_module",
    "delete_module", "kexec_load", "kexec_file_load", "reboot", "swapon", "swapoff", "syslog", "quotactl",
    "quotactl_fd", "acct", "settimeofday", "clock_settime", "clock_adjtime", "adjtimex", "sethostname", "setdomainname",
    "iopl", "ioperm", "modify_ldt", "personality", "vhangup", "lookup_dcookie"};

constexpr const char* makers[] = {"fork", "vfork"};

struct Release {
    void operator()(void* filter) const { seccomp_release(filter); }
};
using Filter = std::unique_ptr<void, Release>;

void expect(int result) {
    if (result < 0) throw Error(fmt::format("no filter of system calls: {}", std::strerror(-result)));
}

/// Refuses a call. A call that this architecture does not have needs no rule.
void refuse(const Filter& filter, const char* name, int error) {
    const int number = seccomp_syscall_resolve_name(name);
    if (number != __NR_SCMP_ERROR && number >= 0)
        expect(seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(unsigned(error)), number, 0));
}

void refuse_clone(const Filter& filter, uint64_t mask, uint64_t value) {
    const scmp_arg_cmp flags = SCMP_A0(SCMP_CMP_MASKED_EQ, mask, value);
    expect(seccomp_rule_add_array(filter.get(), SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1, &flags));
}

}  // namespace

std::string call_filter(bool makes_processes) {
    const Filter filter(seccomp_init(SCMP_ACT_ALLOW));
    if (!filter) throw Error("no filter of system calls: libseccomp does not know this machine");
    // Calls through another architecture's numbers would bypass the rules.
    expect(seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_ERRNO(ENOSYS)));
    for (const char* name : absent) refuse(filter, name, ENOSYS);
    for (const char* name : refused) refuse(filter, name, EPERM);
    if (makes_processes) {
        for (const uint64_t space :
             {CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWIPC, CLONE_NEWUTS, CLONE_NEWCGROUP})
            refuse_clone(filter, space, space);
    } else {
        for (const char* name : makers) refuse(filter, name, EPERM);
        refuse_clone(filter, CLONE_THREAD, 0);
    }
    // The library writes to a descriptor. A pipe's buffer is large enough for a filter.
    Pipe pipe;
    expect(seccomp_export_bpf(filter.get(), pipe.write));
    pipe.write.close();
    std::string bytes;
    char block[4096];
    for (ssize_t got; (got = read(pipe.read, block, sizeof block)) > 0;) bytes.append(block, size_t(got));
    return bytes;
}

}  // namespace relief::grade
