// The system calls that an untrusted program may not make.
#pragma once

#include <string>

namespace relief::grade {

/// Returns a filter of system calls for ProcessJob::calls, in the kernel's format (struct sock_filter). It refuses
/// calls that no student's program needs and calls that escape other limits. These are memory charged to no process
/// (memfd_create, System V), access to other processes (ptrace and the like), sockets, new namespaces, mounts, keys,
/// io_uring, bpf, clocks and modules. A refused call fails with EPERM, or with ENOSYS if libraries then fall back to
/// another call. Without `makes_processes` the program can start threads, but no other process. Throws Error if
/// libseccomp does not support the machine.
std::string call_filter(bool makes_processes);

}  // namespace relief::grade
