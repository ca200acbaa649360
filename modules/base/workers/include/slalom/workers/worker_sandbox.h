// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace slalom {

/// Whether the kernel can confine a process to folders: Landlock, Linux 5.13 or later.
bool can_sandbox();

/// From now on this process and all that it starts can change files only beneath `folders`, and
/// write to /dev/null; since Linux 6.12 they also can send signals to each other only. Open files
/// remain open. Irrevocable. False if that is not possible; the process is as before then, except
/// that it cannot gain privileges.
bool confine_writing_to(const std::vector<std::string>& folders);

/// From now on this process and all that it starts can make no sockets of a network, only within
/// the machine (AF_UNIX); open sockets remain open. Irrevocable. False if the kernel cannot do that
/// (seccomp).
bool close_networks();

/// A new folder for the temporary files of one worker; "" if it cannot be created.
std::string make_scratch_folder();

}  // namespace slalom
