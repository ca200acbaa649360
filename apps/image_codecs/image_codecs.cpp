// SPDX-License-Identifier: BSD-3-Clause
// Each function of opencv2/imgcodecs.hpp calls the one of OpenCV's own library.
#include <dlfcn.h>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

namespace {

[[noreturn]] void fail() {
  CV_Error(cv::Error::StsError, dlerror());
}

/// Beside OpenCV's core, by its path: the name alone is that of this library.
void* load() {
  Dl_info core;
  if (dladdr(reinterpret_cast<void*>(&cv::getVersionString), &core) == 0) fail();
  std::string path = core.dli_fname;
  const std::string of_core = "opencv_core";
  const std::size_t name = path.rfind(of_core);
  if (name != std::string::npos) path.replace(name, of_core.size(), "opencv_imgcodecs");
  void* const library = dlopen(path.c_str(), RTLD_LAZY);
  if (library == nullptr) fail();
  return library;
}

/// OpenCV's function of the same name as `mine`.
template <typename Function>
Function real(Function mine) {
  static void* const library = load();
  Dl_info self;
  void* function = nullptr;
  if (dladdr(reinterpret_cast<void*>(mine), &self) != 0) function = dlsym(library, self.dli_sname);
  if (function == nullptr) fail();
  return reinterpret_cast<Function>(function);
}

}  // namespace

namespace cv {

bool haveImageReader(const String& filename) {
  return real(haveImageReader)(filename);
}

bool haveImageWriter(const String& filename) {
  return real(haveImageWriter)(filename);
}

size_t imcount(const String& filename, int flags) {
  return real(imcount)(filename, flags);
}

Mat imdecode(InputArray buf, int flags) {
  return real<Mat (*)(InputArray, int)>(imdecode)(buf, flags);
}

Mat imdecode(InputArray buf, int flags, Mat* dst) {
  return real<Mat (*)(InputArray, int, Mat*)>(imdecode)(buf, flags, dst);
}

bool imencode(const String& ext, InputArray img, std::vector<uchar>& buf,
              const std::vector<int>& params) {
  return real(imencode)(ext, img, buf, params);
}

Mat imread(const String& filename, int flags) {
  return real(imread)(filename, flags);
}

bool imreadmulti(const String& filename, std::vector<Mat>& mats, int flags) {
  return real<bool (*)(const String&, std::vector<Mat>&, int)>(imreadmulti)(filename, mats, flags);
}

bool imreadmulti(const String& filename, std::vector<Mat>& mats, int start, int count, int flags) {
  return real<bool (*)(const String&, std::vector<Mat>&, int, int, int)>(imreadmulti)(
      filename, mats, start, count, flags);
}

bool imwrite(const String& filename, InputArray img, const std::vector<int>& params) {
  return real(imwrite)(filename, img, params);
}

}  // namespace cv
