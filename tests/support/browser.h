// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "memory_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace slalom {

inline bool has_browser() {
  return std::system("command -v chromium >/dev/null 2>&1") == 0;
}

/// Whether the page's timers end at once, or its clock is real and what follows its load is not
/// waited for.
enum class PageTime { Virtual, Real };

constexpr const char* kStartBrowser = "exec chromium --headless --no-sandbox --disable-gpu ";
constexpr const char* kSilently = " >/dev/null 2>&1 </dev/null";

/// A browser that stays open for all pages of a test program, as each start takes seconds of the
/// processor. Controlled by the Chrome DevTools Protocol over two pipes.
class Browser {
 public:
  explicit Browser(const std::string& options) {
    std::string pattern = (memory_folder() / "slalom_browser_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    const std::string command = kStartBrowser + ("--remote-debugging-pipe --user-data-dir='" +
                                                 folder_.string() + "' " + options + kSilently);
    int to[2] = {}, from[2] = {};
    if (pipe2(to, O_CLOEXEC) != 0 || pipe2(from, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipes");
    process_ = fork();
    if (process_ == 0) {
      constexpr int kReads = 3, kWrites = 4;  // descriptors of the protocol
      const int reads = fcntl(to[0], F_DUPFD_CLOEXEC, kWrites + 1),
                writes = fcntl(from[1], F_DUPFD_CLOEXEC, kWrites + 1);
      dup2(reads, kReads);
      dup2(writes, kWrites);
      execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    close(to[0]);
    close(from[1]);
    to_ = to[1];
    from_ = from[0];
  }
  /// The browser ends when its pipes do.
  ~Browser() {
    close(to_);
    close(from_);
    waitpid(process_, nullptr, 0);
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// The document of an address. The console must stay empty. All addresses are opened in one tab,
  /// as a tab of its own takes a second of the processor. Throws std::runtime_error if the browser
  /// does not answer as expected.
  std::string open(const std::string& address, PageTime time) {
    std::string& tab = tabs_[time];
    if (tab.empty()) tab = open_tab();
    session_ = tab;
    const bool is_virtual = time == PageTime::Virtual;
    // Time that a budget has stopped runs again, for the page to load.
    if (is_virtual) ask("Emulation.setVirtualTimePolicy", {{"policy", "advance"}});
    navigate("about:blank");  // else another fragment of the same file would not load it
    navigate(address);
    if (is_virtual) {
      ask("Emulation.setVirtualTimePolicy", {{"policy", "pauseIfNetworkFetchesPending"},
                                             {"budget", kVirtualTime},
                                             {"maxVirtualTimeTaskStarvationCount", 9999}});
      await_event("Emulation.virtualTimeBudgetExpired");
    }
    const Json document =
        ask("Runtime.evaluate", {{"expression", "document.documentElement.outerHTML"}});
    EXPECT_EQ(console_, "") << address;
    return document.at("result").at("value");
  }

 private:
  using Json = nlohmann::json;
  static constexpr int kVirtualTime = 3000;  // ms

  std::string open_tab() {
    session_.clear();
    const Json target = ask("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    session_ = ask("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
    for (const char* domain : {"Page", "Runtime", "Log"}) ask(domain + std::string(".enable"));
    return session_;
  }
  void navigate(const std::string& address) {
    happened_.clear();
    console_.clear();
    const Json started = ask("Page.navigate", {{"url", address}});
    if (started.count("errorText") > 0) throw std::runtime_error(started["errorText"]);
    await_event("Page.loadEventFired");
  }
  /// The result of a command.
  Json ask(const std::string& method, const Json& parameters = Json::object()) {
    Json command = {{"id", ++last_id_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) command["sessionId"] = session_;
    const std::string text = command.dump() + '\0';
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t written = ::write(to_, text.data() + at, text.size() - at);
      if (written <= 0) throw std::runtime_error("the browser has ended: " + method);
      at += static_cast<std::size_t>(written);
    }
    for (;;) {
      const Json message = next_message();
      if (message.value("id", 0) != last_id_) continue;
      if (message.count("error") > 0) throw std::runtime_error(method + ": " + message.dump());
      return message.at("result");
    }
  }
  void await_event(const std::string& method) {
    while (happened_.count(method) == 0) next_message();
  }
  /// Messages end with a zero byte.
  Json next_message() {
    std::size_t end = 0;
    while ((end = received_.find('\0')) == std::string::npos) {
      char buffer[65536];
      const ssize_t size = ::read(from_, buffer, sizeof buffer);
      if (size <= 0) throw std::runtime_error("the browser has ended");
      received_.append(buffer, static_cast<std::size_t>(size));
    }
    Json message = Json::parse(received_.substr(0, end));
    received_.erase(0, end + 1);
    if (message.value("sessionId", "") != session_ || message.count("method") == 0) return message;
    const std::string method = message["method"];
    ++happened_[method];
    if (method == "Runtime.consoleAPICalled" || method == "Runtime.exceptionThrown" ||
        (method == "Log.entryAdded" && is_of_the_page(message["params"]["entry"])))
      console_ += message["params"].dump() + '\n';
    return message;
  }
  /// Remarks about speed are the machine's; probes forbid scripts in frames.
  static bool is_of_the_page(const Json& entry) {
    return entry.at("level") != "verbose" &&
           entry.at("text").get<std::string>().find("Blocked script") == std::string::npos;
  }

  std::filesystem::path folder_;  ///< of its profile
  pid_t process_ = -1;
  int to_ = -1, from_ = -1, last_id_ = 0;
  std::map<PageTime, std::string> tabs_;  ///< their sessions; virtual time cannot be left
  std::string session_;                   ///< of the tab in use
  std::string received_;                  ///< not yet decoded
  std::map<std::string, int> happened_;   ///< numbers of events since the last address
  std::string console_;                   ///< messages since the last address
};

/// The document of a local file (with a fragment or without) after its scripts have run, which must
/// not report errors. Pages with the same `options` of the browser share one.
inline std::string open_in_browser(const std::string& file, const std::string& options = "",
                                   PageTime time = PageTime::Virtual) {
  static std::map<std::string, std::unique_ptr<Browser>> browsers;
  std::unique_ptr<Browser>& browser = browsers[options];
  try {
    if (browser == nullptr) browser = std::make_unique<Browser>(options);
    return browser->open("file://" + file, time);
  } catch (const std::exception& error) {
    ADD_FAILURE() << file << ": " << error.what();
    browser.reset();
    return "";
  }
}

/// Prints a local file into a PDF. `folder` takes temporary files.
inline void print_in_browser(const std::string& file, const std::filesystem::path& folder,
                             const std::string& pdf) {
  const std::string command =
      kStartBrowser +
      ("--virtual-time-budget=3000 --user-data-dir='" + (folder / ".profile").string() +
       "' --print-to-pdf='" + pdf + "' 'file://" + file + "'" + kSilently);
  EXPECT_EQ(std::system(command.c_str()), 0) << file;
}

/// The first group of every match.
inline std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
    found.push_back((*i)[1]);
  return found;
}

}  // namespace slalom
