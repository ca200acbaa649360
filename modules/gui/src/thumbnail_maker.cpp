#include <slalom/core/error.h>
#include <slalom/gui/jobs.h>
#include <slalom/gui/thumbnails.h>
#include <slalom/io/scenario_list.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::size_t kAtOnce = 4;  // few, so that what is seen now soon has its turn

using Made = std::vector<std::pair<std::string, Thumbnail>>;

/// In a worker. What cannot be read gets an empty picture, so that it is not asked for again.
Made make_thumbnails(const std::string& path, const std::vector<std::string>& hashes,
                     Progress& progress) {
  Made made;
  progress.start("Drawing thumbnails", hashes.size());
  const ScenarioList list = ScenarioList::open(path);
  for (const std::string& hash : hashes) {
    try {
      made.emplace_back(hash, make_thumbnail(list.read(hash)));
    } catch (const Error&) {
      made.emplace_back(hash, Thumbnail{});
    }
    progress.advance(made.size());
  }
  return made;
}

}  // namespace

ThumbnailMaker::ThumbnailMaker(Jobs& jobs)
    : jobs_(jobs), alive_(std::make_shared<ThumbnailMaker*>(this)) {}

void ThumbnailMaker::want(const std::string& list_path, std::vector<std::string> hashes) {
  path_ = list_path;
  wanted_ = std::move(hashes);
  if (!working_ && !wanted_.empty()) work();
}

void ThumbnailMaker::work() {
  working_ = true;
  const std::vector<std::string> now(
      wanted_.begin(),
      wanted_.begin() + static_cast<std::ptrdiff_t>(std::min(wanted_.size(), kAtOnce)));
  const auto deliver = [alive = std::weak_ptr<ThumbnailMaker*>(alive_)](const Made& made) {
    const auto maker = alive.lock();
    if (!maker) return;
    ThumbnailMaker& self = **maker;
    self.working_ = false;
    for (const auto& [hash, picture] : made) {
      self.wanted_.erase(std::remove(self.wanted_.begin(), self.wanted_.end(), hash),
                         self.wanted_.end());
      if (self.on_ready) self.on_ready(hash, picture);
    }
    if (!self.wanted_.empty()) self.work();
  };
  jobs_.start(
      "thumbnails", "Thumbnails",
      [path = path_, now, deliver](Progress& progress) -> Jobs::Delivery {
        auto made = make_thumbnails(path, now, progress);
        return [made = std::move(made), deliver] { deliver(made); };
      },
      [now, deliver](const std::string&) {  // the file is gone
        Made none;
        for (const std::string& hash : now) none.emplace_back(hash, Thumbnail{});
        deliver(none);
      },
      false);
}

}  // namespace slalom
