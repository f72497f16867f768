// Records in MRPT's own format, which rawlog-edit, RawLogViewer and SceneViewer3D read: per world state one odometry
// observation of every robot, labelled "Y3", and once a second of the field's time the whole scene.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "modules/viewer/viewer_scene.h"

namespace regista {

struct RecordError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class RawlogRecorder {
 public:
  /// Overwrites the file. Throws RecordError with one line when it cannot be written.
  explicit RawlogRecorder(const std::string& file);
  /// Completes the file.
  ~RawlogRecorder();
  RawlogRecorder(const RawlogRecorder&) = delete;
  RawlogRecorder& operator=(const RawlogRecorder&) = delete;

  /// Call it for every world state. Throws RecordError when the file takes no more.
  void record(const ViewerScene& scene);

 private:
  struct Output;
  std::unique_ptr<Output> output_;
};

}  // namespace regista
