#include <slalom/core/error.h>
#include <slalom/io/scenario_list.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/thumbnails.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::size_t kBatchSize = 4;  // small, so that the visible rows are soon drawn

using Batch = std::vector<std::pair<std::string, Thumbnail>>;

/// Runs in a worker thread. Unreadable scenarios get an empty thumbnail, so that they are not
/// requested again.
Batch make_thumbnails(const std::string& path, const std::vector<std::string>& hashes,
                      Progress& progress) {
  Batch batch;
  progress.start("Drawing thumbnails", hashes.size());
  const ScenarioList list = ScenarioList::open(path);
  for (const std::string& hash : hashes) {
    try {
      batch.emplace_back(hash, make_thumbnail(list.read(hash)));
    } catch (const Error&) {
      batch.emplace_back(hash, Thumbnail{});
    }
    progress.advance(batch.size());
  }
  return batch;
}

}  // namespace

ThumbnailMaker::ThumbnailMaker(Jobs& jobs, Ready ready)
    : jobs_(jobs), ready_(std::move(ready)), alive_(std::make_shared<ThumbnailMaker*>(this)) {}

void ThumbnailMaker::request(const std::string& list_path, std::vector<std::string> hashes) {
  path_ = list_path;
  requested_ = std::move(hashes);
  if (!working_ && !requested_.empty()) work();
}

void ThumbnailMaker::work() {
  working_ = true;
  const std::vector<std::string> now(
      requested_.begin(),
      requested_.begin() + static_cast<std::ptrdiff_t>(std::min(requested_.size(), kBatchSize)));
  const auto deliver = [alive = std::weak_ptr<ThumbnailMaker*>(alive_)](const Batch& batch) {
    const auto maker = alive.lock();
    if (!maker) return;
    ThumbnailMaker& self = **maker;
    self.working_ = false;
    for (const auto& [hash, thumbnail] : batch) {
      self.requested_.erase(std::remove(self.requested_.begin(), self.requested_.end(), hash),
                            self.requested_.end());
      self.ready_(hash, thumbnail);
    }
    if (!self.requested_.empty()) self.work();
  };
  jobs_.start(
      "thumbnails", "Thumbnails",
      [path = path_, now, deliver](Progress& progress) -> Jobs::Delivery {
        auto batch = make_thumbnails(path, now, progress);
        return [batch = std::move(batch), deliver] { deliver(batch); };
      },
      [now, deliver](const std::string&) {  // the list cannot be opened
        Batch none;
        for (const std::string& hash : now) none.emplace_back(hash, Thumbnail{});
        deliver(none);
      },
      false);
}

}  // namespace slalom
