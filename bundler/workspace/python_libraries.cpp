// See python_libraries.hpp.
#include "bundler/workspace/python_libraries.hpp"

#include <algorithm>
#include <array>

#include "workspace_schema/base/json_reader.hpp"
#include "workspace_schema/conda/wheel_name.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kAbi = "2024_0";
constexpr std::string_view kIndexBegin = "https://cdn.jsdelivr.net/pyodide/v";
constexpr std::string_view kIndexEnd = "/full/";

struct OtherName {
  std::string_view name;
  std::string_view project;
};

/// Names of rosdep and of people where they are neither a project's nor a module's.
constexpr auto kOtherNames = std::to_array<OtherName>({
    {"opencv", "opencv-python"},
    {"opencv-contrib-python", "opencv-python"},
    {"opencv-headless", "opencv-python"},
    {"opencv-python-headless", "opencv-python"},
    {"pil", "pillow"},
    {"pil-imagetk", "pillow"},
});

/// The names that the embedded channel's `scipy` has (runtime/packages/tools/scipy).
constexpr std::string_view kScipy = "scipy";
constexpr auto kScipyNames = std::to_array<std::string_view>({
    "scipy",
    "scipy.spatial",
    "scipy.spatial.transform",
    "scipy.spatial.transform.Rotation",
    "scipy.spatial.transform.Slerp",
});

/// Names of OpenCV that the embedded channel's `cv2` does not have
/// (runtime/packages/vendor/py_opencv).
constexpr std::string_view kOpenCv = "cv2";
constexpr auto kNotOfOpenCv = std::to_array<std::string_view>({
    "BOWKMeansTrainer",
    "CascadeClassifier",
    "DISOpticalFlow_create",
    "EMD",
    "FileStorage",
    "FlannBasedMatcher",
    "GeneralizedHoughBallard",
    "HOGDescriptor",
    "LineSegmentDetector",
    "MSER_create",
    "Mahalanobis",
    "PCABackProject",
    "PCACompute",
    "PCACompute2",
    "PCAProject",
    "QRCodeEncoder",
    "RQDecomp3x3",
    "SIFT",
    "SIFT_create",
    "SVDecomp",
    "StereoBM",
    "StereoBM_create",
    "StereoSGBM",
    "StereoSGBM_create",
    "Stitcher",
    "Stitcher_create",
    "Subdiv2D",
    "TrackerCSRT_create",
    "TrackerKCF_create",
    "TrackerMIL_create",
    "UMat",
    "barcode",
    "bgsegm",
    "bioinspired",
    "buildOpticalFlowPyramid",
    "buildPyramid",
    "calcCovarMatrix",
    "calibrateHandEye",
    "calibrateRobotWorldHandEye",
    "ccm",
    "colorChange",
    "composeRT",
    "computeCorrespondEpilines",
    "convertFp16",
    "convertPointsFromHomogeneous",
    "convertPointsToHomogeneous",
    "cornerEigenValsAndVecs",
    "correctMatches",
    "createBackgroundSubtractorKNN",
    "createLineSegmentDetector",
    "cuda",
    "data",
    "dct",
    "decolor",
    "decomposeEssentialMat",
    "decomposeHomographyMat",
    "decomposeProjectionMatrix",
    "denoise_TVL1",
    "detail",
    "detailEnhance",
    "dnn",
    "dnn_superres",
    "drawChessboardCorners",
    "edgePreservingFilter",
    "estimateAffine3D",
    "estimateAffinePartial2D",
    "face",
    "fastNlMeansDenoising",
    "fastNlMeansDenoisingColored",
    "findChessboardCorners",
    "findChessboardCornersSB",
    "findCirclesGrid",
    "findEssentialMat",
    "findFundamentalMat",
    "fisheye",
    "flann",
    "freetype",
    "gapi",
    "getGaborKernel",
    "hfs",
    "idct",
    "img_hash",
    "initCameraMatrix2D",
    "intensity_transform",
    "ipp",
    "legacy",
    "line_descriptor",
    "linearPolar",
    "logPolar",
    "matMulDeriv",
    "mcc",
    "ml",
    "motempl",
    "mulSpectrums",
    "mulTransposed",
    "multicalib",
    "ocl",
    "optflow",
    "pencilSketch",
    "phaseCorrelate",
    "phase_unwrapping",
    "plot",
    "pyrMeanShiftFiltering",
    "quality",
    "rapid",
    "recoverPose",
    "reg",
    "reprojectImageTo3D",
    "rgbd",
    "saliency",
    "seamlessClone",
    "segmentation",
    "selectROI",
    "selectROIs",
    "solveP3P",
    "solvePnPGeneric",
    "stereoCalibrate",
    "stereoRectify",
    "stereoRectifyUncalibrated",
    "structured_light",
    "stylization",
    "surface_matching",
    "text",
    "textureFlattening",
    "triangulatePoints",
    "utils",
    "validateDisparity",
    "videostab",
    "wechat_qrcode",
    "xfeatures2d",
    "ximgproc",
    "xphoto",
});

Diagnostic no_lock(const std::string& file, std::string why) {
  return Diagnostic{.code = "R2W0128",
                    .message = "`" + file + "` is not a lock file of Pyodide that sites can use",
                    .why = {std::move(why)}};
}

bool is_hash(const std::string& text) {
  constexpr std::size_t kDigits = 64;
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool is_file_name(const std::string& text) {
  return !text.empty() && text.front() != '.' && text.find_first_of("/\\:") == std::string::npos;
}

bool is_of_scipy(const std::string& name) {
  return std::find(kScipyNames.begin(), kScipyNames.end(), name) != kScipyNames.end();
}

bool is_of_opencv(const std::string& name) {
  return std::find(kNotOfOpenCv.begin(), kNotOfOpenCv.end(), name) == kNotOfOpenCv.end();
}

std::string known_project(const std::string& name, const PythonLibraries& libraries) {
  if (libraries.by_project.contains(name)) return name;
  std::string module = name;
  std::replace(module.begin(), module.end(), '-', '_');
  for (const std::string& one : {name, module}) {
    const auto found = libraries.project_of.find(one);
    if (found != libraries.project_of.end()) return found->second;
  }
  const auto other = std::find_if(kOtherNames.begin(), kOtherNames.end(),
                                  [&](const OtherName& row) { return row.name == name; });
  return other == kOtherNames.end() ? std::string() : std::string(other->project);
}

/// Tests of libraries, and parts of Python itself, which are not libraries.
bool is_left_out(const std::string& name, const JsonValue& row) {
  return name.ends_with("-tests") || name.ends_with("-test") ||
         row.text_of("package_type") == "cpython_module";
}

void add_library(const std::string& name, const JsonValue& row, PythonLibraries& result) {
  LockedLibrary library{.project = normal_project_name(name),
                        .version = row.text_of("version"),
                        .file = row.text_of("file_name"),
                        .sha256 = row.text_of("sha256"),
                        .depends = {}};
  if (const JsonValue* depends = row.find("depends")) {
    for (const JsonValue& one : depends->items())
      if (const std::string* text = one.string())
        library.depends.push_back(normal_project_name(*text));
  }
  std::sort(library.depends.begin(), library.depends.end());
  if (const JsonValue* imports = row.find("imports")) {
    for (const JsonValue& one : imports->items()) {
      if (const std::string* module = one.string())
        result.project_of.emplace(module->substr(0, module->find('.')), library.project);
    }
  }
  std::string project = library.project;
  result.by_project.emplace(std::move(project), std::move(library));
}

}  // namespace

Outcome<PythonLibraries> read_python_libraries(std::string_view text, const std::string& file) {
  const auto json = parse_json(text, file, "R2W0128");
  if (!json) return json.errors();
  const JsonValue* info = json->find("info");
  const JsonValue* packages = json->find("packages");
  if (info == nullptr || packages == nullptr || packages->members().empty())
    return no_lock(file, "it lists no libraries");
  if (info->text_of("abi_version") != kAbi)
    return no_lock(file, "its libraries are for the ABI `" + info->text_of("abi_version") + "`");
  PythonLibraries result;
  result.index = std::string(kIndexBegin) + info->text_of("version") + std::string(kIndexEnd);
  for (const auto& [name, row] : packages->members()) {
    if (is_left_out(name, row)) continue;
    if (!is_hash(row.text_of("sha256")) || !is_file_name(row.text_of("file_name")))
      return no_lock(file, "`" + name + "` has no file name or no sha256");
    add_library(name, row, result);
  }
  return result;
}

std::string library_project(std::string_view name, const PythonLibraries& libraries) {
  constexpr std::string_view kPython3 = "python3-";
  constexpr std::string_view kPython = "python-";
  constexpr std::string_view kPip = "-pip";
  if (std::string found = known_project(normal_project_name(name), libraries); !found.empty())
    return found;
  if (const auto module = libraries.project_of.find(std::string(name));
      module != libraries.project_of.end())
    return module->second;
  if (name.ends_with(kPip)) name.remove_suffix(kPip.size());
  for (const std::string_view begin : {kPython3, kPython}) {
    if (name.starts_with(begin))
      return known_project(normal_project_name(name.substr(begin.size())), libraries);
  }
  return {};
}

std::vector<std::string> libraries_in_order(
    const std::set<std::string>& projects,
    const std::map<std::string, std::vector<std::string>>& depends) {
  std::vector<std::string> order;
  std::set<std::string> seen;
  struct Open {
    const std::string* project;
    const std::vector<std::string>* needs;
    std::size_t next = 0;
  };
  // Not by recursion: a lock file may have chains as long as it likes.
  std::vector<Open> open;
  const auto begin = [&](const std::string& project) {
    const auto row = depends.find(project);
    if (row != depends.end() && seen.insert(project).second)
      open.push_back({&row->first, &row->second});
  };
  for (const std::string& one : projects) {
    begin(one);
    while (!open.empty()) {
      Open& top = open.back();
      if (top.next < top.needs->size()) {
        begin((*top.needs)[top.next++]);
        continue;
      }
      order.push_back(*top.project);
      open.pop_back();
    }
  }
  return order;
}

std::optional<bool> stand_in_has(std::string_view module, const std::vector<std::string>& names,
                                 const std::vector<std::string>& attributes) {
  const std::string whole(module);
  const auto has_all = [&](const auto& is_there) {
    const auto is_met = [&](const std::string& name) {
      return name == "*" || name.starts_with('_') || is_there(name);
    };
    return std::all_of(names.begin(), names.end(), is_met) &&
           std::all_of(attributes.begin(), attributes.end(), is_met);
  };
  const std::string_view top = module.substr(0, module.find('.'));
  if (top == kScipy)
    return is_of_scipy(whole) &&
           has_all([&](const std::string& name) { return is_of_scipy(whole + "." + name); });
  if (top != kOpenCv) return std::nullopt;
  return (top == module || is_of_opencv(whole.substr(top.size() + 1))) && has_all(is_of_opencv);
}

}  // namespace ros2wasm
