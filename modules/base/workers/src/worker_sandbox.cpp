// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/workers/worker_sandbox.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

/// The attributes of newer kernels than the header's: it may lack the last two.
struct Ruleset {
  std::uint64_t files, network, scope;
};
constexpr std::uint64_t kTruncate = 1U << 14, kScopeSignals = 1U << 1;
constexpr int kAbiOfRefer = 2, kAbiOfTruncate = 3, kAbiOfScope = 6;

/// 0 if there is none.
int landlock_abi() {
  const long abi =
      syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return abi < 0 ? 0 : static_cast<int>(abi);
}

/// Everything that changes files, as far as the kernel knows it.
std::uint64_t write_access(int abi) {
  std::uint64_t access = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                         LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                         LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                         LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                         LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;
  if (abi >= kAbiOfRefer) access |= LANDLOCK_ACCESS_FS_REFER;
  if (abi >= kAbiOfTruncate) access |= kTruncate;
  return access;
}

/// The size of the attributes that a kernel knows; larger ones are an error.
std::size_t size_for(int abi) {
  return abi >= kAbiOfScope ? sizeof(Ruleset) : sizeof(std::uint64_t);
}

bool allow(int ruleset, const std::string& path, std::uint64_t access) {
  const int file = open(path.c_str(), O_PATH | O_CLOEXEC);
  if (file < 0) return false;
  landlock_path_beneath_attr rule = {access, file};
  const bool allowed =
      syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
  close(file);
  return allowed;
}

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;  // none: such a sandbox cannot be made
#endif

/// Landlock has no rights for these calls, and io_uring makes calls past the filter. Some exist on
/// some processors only.
constexpr int kForbidden[] = {
    // permissions, owners, times and extended attributes of files
    SYS_fchmod, SYS_fchmodat, SYS_fchown, SYS_fchownat, SYS_utimensat, SYS_setxattr, SYS_lsetxattr,
    SYS_fsetxattr, SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr,
    452,       // fchmodat2
    463, 466,  // setxattrat, removexattrat
    468,       // file_setattr
#ifdef SYS_chmod
    SYS_chmod, SYS_chown, SYS_lchown, SYS_utime, SYS_utimes, SYS_futimesat,
#endif
    SYS_io_uring_setup,
    // the machine, which root can change
    SYS_sethostname, SYS_setdomainname, SYS_settimeofday, SYS_clock_settime, SYS_adjtimex,
    SYS_clock_adjtime, SYS_reboot, SYS_swapon, SYS_swapoff, SYS_acct, SYS_quotactl, SYS_kexec_load,
    SYS_init_module, SYS_finit_module, SYS_delete_module,
    // memory of other processes
    SYS_migrate_pages, SYS_process_madvise,
    448,  // process_mrelease
};

/// The calls that set something of the process with the number of their first argument, 0: itself.
constexpr int kOfProcess[] = {SYS_prlimit64,      SYS_sched_setaffinity, SYS_sched_setscheduler,
                              SYS_sched_setparam, SYS_sched_setattr,     SYS_move_pages};

/// The calls that set a priority of a process, group or user, their first argument. The numbers of
/// those that a user is.
constexpr std::pair<int, int> kOfGroup[] = {{SYS_setpriority, PRIO_USER}, {SYS_ioprio_set, 3}};

/// A program that decides which calls fail with EPERM: those of another architecture's conventions,
/// and those added.
class CallFilter {
 public:
  CallFilter() {
    constexpr std::uint32_t kX32 = 0x40000000;
    program_ = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
                BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0),
                refusal_,
                BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, kX32, 0, 1),
                refusal_};
  }

  void refuse(int call) {
    program_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1));
    program_.push_back(refusal_);
  }

  /// Refuses a call unless its first argument is 0.
  void refuse_for_others(int call) {
    refuse_unless(call, {load_argument(0), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 1, 0), refusal_});
  }

  /// Refuses a call if its first argument is `user`, or its second one not 0.
  void refuse_for_others(int call, int user) {
    refuse_unless(call,
                  {load_argument(0),
                   BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(user), 2, 0),
                   load_argument(1), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 1, 0), refusal_});
  }

  /// Refuses socket() but for sockets within the machine.
  void refuse_networks() {
    refuse_unless(SYS_socket,
                  {load_argument(0), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_UNIX, 1, 0), refusal_});
  }

  /// Applies it to this process and all that it starts; false if that is not possible.
  bool enter() {
    if (kArchitecture == 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
    program_.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    const sock_fprog filter = {static_cast<unsigned short>(program_.size()), program_.data()};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
  }

 private:
  /// The lower half: all that the kernel reads of an int.
  static sock_filter load_argument(std::size_t i) {
    return BPF_STMT(
        BPF_LD | BPF_W | BPF_ABS,
        static_cast<std::uint32_t>(offsetof(seccomp_data, args) + i * sizeof(std::uint64_t)));
  }

  /// A rule for one call; the next rule finds the number of the call again.
  void refuse_unless(int call, const std::vector<sock_filter>& rule) {
    program_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0,
                                static_cast<std::uint8_t>(rule.size() + 1)));
    program_.insert(program_.end(), rule.begin(), rule.end());
    program_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)));
  }

  const sock_filter refusal_ = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
  std::vector<sock_filter> program_;
};

bool forbid_what_landlock_allows() {
  CallFilter filter;
  for (const int call : kForbidden) filter.refuse(call);
  for (const int call : kOfProcess) filter.refuse_for_others(call);
  for (const auto& [call, user] : kOfGroup) filter.refuse_for_others(call, user);
  return filter.enter();
}

}  // namespace

bool can_sandbox() {
  return landlock_abi() > 0 && kArchitecture != 0;
}

bool confine_writing_to(const std::vector<std::string>& folders) {
  const int abi = landlock_abi();
  const std::uint64_t access = write_access(abi);
  const Ruleset rules = {access, 0, abi >= kAbiOfScope ? kScopeSignals : 0};
  const int ruleset =
      static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, size_for(abi), 0));
  if (ruleset < 0) return false;
  bool confined = allow(ruleset, "/dev/null", LANDLOCK_ACCESS_FS_WRITE_FILE);
  for (const std::string& folder : folders) confined = confined && allow(ruleset, folder, access);
  confined = confined && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
             syscall(SYS_landlock_restrict_self, ruleset, 0) == 0 && forbid_what_landlock_allows();
  close(ruleset);
  return confined;
}

bool close_networks() {
  CallFilter filter;
  filter.refuse(SYS_io_uring_setup);
  filter.refuse_networks();
  return filter.enter();
}

std::string make_scratch_folder() {
  std::error_code error;
  std::string path =
      (std::filesystem::temp_directory_path(error) / "slalom-worker-XXXXXX").string();
  return mkdtemp(path.data()) == nullptr ? "" : path;
}

}  // namespace slalom
