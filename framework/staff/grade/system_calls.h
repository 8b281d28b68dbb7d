// What an untrusted program may not ask the system for.
#pragma once

#include <string>

namespace relief {

/// A filter of system calls for ProcessJob::calls, in the form that the kernel takes (struct sock_filter). It refuses
/// what no student's program needs and what escapes other limits: memory that counts as nobody's (memfd_create, System
/// V), other processes (ptrace and the like), sockets, new namespaces, mounts, keys, io_uring, bpf, clocks, modules.
/// A refused call fails with EPERM, or with ENOSYS where libraries then take another way. Without `makes_processes` it
/// can start threads, and no other process. Throws Error where libseccomp does not know the machine.
std::string call_filter(bool makes_processes);

}  // namespace relief
