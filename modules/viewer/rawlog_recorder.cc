#include "modules/viewer/rawlog_recorder.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation3DScene.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/serialization/CArchive.h>

#include <optional>

#include "modules/viewer/scene_builder.h"
#include "world_model/types/body_velocity.h"

namespace regista {
namespace {

constexpr Duration kSceneEvery = std::chrono::seconds(1);

// The picture's size that a recorded scene's camera and text are made for; a viewer may show it at any other.
constexpr int kWidth_px = 1280;
constexpr int kHeight_px = 800;

mrpt::Clock::time_point to_mrpt(Time time) { return mrpt::Clock::fromDouble(static_cast<double>(to_us(time)) * 1e-6); }

mrpt::obs::CObservationOdometry::Ptr observation_of(const RobotState& robot, Time captured) {
  auto observation = mrpt::obs::CObservationOdometry::Create();
  observation->sensorLabel = to_string(robot.id);
  observation->timestamp = to_mrpt(captured);
  const Vec2& position = robot.pose.position_m;
  observation->odometry = mrpt::poses::CPose2D(position.x(), position.y(), robot.pose.heading_rad);
  const BodyVelocity body = to_body(robot.twist, robot.pose.heading_rad);
  observation->hasVelocities = true;
  observation->velocityLocal = {body.forward_mps, body.left_mps, body.angular_radps};
  return observation;
}

mrpt::obs::CObservation3DScene::Ptr observation_of(const ViewerScene& scene) {
  auto observation = mrpt::obs::CObservation3DScene::Create();
  observation->timestamp = to_mrpt(scene.world.captured);
  observation->scene = mrpt::opengl::COpenGLScene::Create();
  fill_scene(*observation->scene, scene, text_height_px(kWidth_px, kHeight_px));
  set_camera(*observation->scene, fitted_view(scene.field, kWidth_px, kHeight_px));
  return observation;
}

}  // namespace

struct RawlogRecorder::Output {
  explicit Output(const std::string& name) : file(name) {}

  RecordError error() const {
    return RecordError("cannot write the recording '" + file + "': is there such a folder, and room in it?");
  }

  template <class Observation>
  void write(const Observation& observation) {
    try {
      mrpt::serialization::archiveFrom(stream) << *observation;
    } catch (const std::exception&) {
      throw error();  // MRPT's text is a call stack
    }
  }

  std::string file;
  mrpt::io::CFileGZOutputStream stream;
  std::optional<Time> scene_recorded;
};

RawlogRecorder::RawlogRecorder(const std::string& file) : output_(std::make_unique<Output>(file)) {
  bool open = false;
  try {
    open = output_->stream.open(file);
  } catch (const std::exception&) {
    // Reported below.
  }
  if (!open) throw output_->error();
}

RawlogRecorder::~RawlogRecorder() = default;

void RawlogRecorder::record(const ViewerScene& scene) {
  const Time captured = scene.world.captured;
  for (const RobotState& robot : scene.world.robots) output_->write(observation_of(robot, captured));
  std::optional<Time>& last = output_->scene_recorded;
  if (last && captured >= *last && captured - *last < kSceneEvery) return;
  output_->write(observation_of(scene));
  last = captured;
}

}  // namespace regista
