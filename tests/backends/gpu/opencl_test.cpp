// The text for GPUs, run by an implementation of OpenCL (PoCL: on the processor), gives the interpreter's results.
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "robcogen/gpu/dialect.h"
#include "states.h"

namespace robcogen::test {
namespace {

using backend::Library;
using backend::gpu::StatesFunction;

void check(cl_int error, const char* what) {
  if (error != CL_SUCCESS)
    throw std::runtime_error(std::string(what) + ": error " + std::to_string(error) + " of OpenCL");
}

// A device that computes in double, and its queue. Kernels that it compiles go to a folder of the test.
struct Device {
  const Scratch cache{"gpu-opencl-cache"};
  cl_device_id id = nullptr;
  cl_context context = nullptr;
  cl_command_queue queue = nullptr;

  Device() {
    setenv("POCL_CACHE_DIR", cache.path.c_str(), 1);
    setenv("POCL_MAX_PTHREAD_COUNT", "1", 1);
    cl_platform_id platform = nullptr;
    if (clGetPlatformIDs(1, &platform, nullptr) != CL_SUCCESS) return;
    if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1, &id, nullptr) != CL_SUCCESS) return;
    cl_int error = CL_SUCCESS;
    context = clCreateContext(nullptr, 1, &id, nullptr, nullptr, &error);
    check(error, "context");
    queue = clCreateCommandQueue(context, id, 0, &error);
    check(error, "queue");
  }
  ~Device() {
    if (queue) clReleaseCommandQueue(queue);
    if (context) clReleaseContext(context);
  }
};

// The kernels of a function, from the text in a folder.
class Kernels {
 public:
  Kernels(
      const Device& device,
      const StatesFunction& f,
      const std::filesystem::path& folder,
      const std::string& header,
      const std::string& prefix,
      const std::string& options)
      : device_(device), f_(f), list_(f.kernels()) {
    const std::string text = "#include \"" + header + "\"\n";
    const char* source = text.c_str();
    cl_int error = CL_SUCCESS;
    program_ = clCreateProgramWithSource(device.context, 1, &source, nullptr, &error);
    check(error, "program");
    const std::string all = "-Werror -I " ROBCOGEN_RUNTIME_DIR " -I " + folder.string() + options;
    if (clBuildProgram(program_, 1, &device.id, all.c_str(), nullptr, nullptr) != CL_SUCCESS) {
      std::string log(20000, '\0');
      clGetProgramBuildInfo(program_, device.id, CL_PROGRAM_BUILD_LOG, log.size(), log.data(), nullptr);
      throw std::runtime_error(log.c_str());
    }
    for (const backend::gpu::StatesKernel& kernel : list_) {
      kernels_.push_back(clCreateKernel(program_, (prefix + kernel.name).c_str(), &error));
      check(error, kernel.name.c_str());
    }
  }
  ~Kernels() {
    for (const cl_kernel kernel : kernels_) clReleaseKernel(kernel);
    clReleaseProgram(program_);
  }
  Kernels(const Kernels&) = delete;
  Kernels& operator=(const Kernels&) = delete;

  // Computes `count` states. More threads than states run, in groups of 32.
  template <class Real>
  void run(int count, std::vector<Memory<Real>>& memory) const {
    std::vector<Buffer> buffers;
    for (std::size_t a = 0; a < memory.size(); ++a) buffers.push_back(buffer(memory[a], f_.arrays[a].size));
    std::vector<Real> workspace(workspace_of(f_, static_cast<std::size_t>(count)));
    if (f_.stages) buffers.push_back({new_buffer(workspace), nullptr, {5, 32 * f_.stages->workspace, 32}});
    for (std::size_t k = 0; k < list_.size(); ++k) {
      cl_uint argument = 0;
      const auto set = [&](const auto& value, const char* what) {
        check(clSetKernelArg(kernels_[k], argument++, sizeof(value), &value), what);
      };
      set(count, "count");
      for (const std::size_t a : list_[k].arrays) {
        set(buffers[a].part ? buffers[a].part : buffers[a].whole, "array");
        set(buffers[a].strides, "strides");
      }
      const std::size_t runs = list_[k].columns ? static_cast<std::size_t>(list_[k].columns->runs) : 1;
      const std::size_t local[] = {32, 1}, global[] = {(static_cast<std::size_t>(count) + 32) / 32 * 32, runs};
      check(
          clEnqueueNDRangeKernel(device_.queue, kernels_[k], 2, nullptr, global, local, 0, nullptr, nullptr), "start");
    }
    check(clFinish(device_.queue), "run");
    for (std::size_t a = 0; a < memory.size(); ++a) {
      std::vector<Real>& numbers = memory[a].numbers();
      const std::size_t bytes = numbers.size() * sizeof(Real);
      check(
          clEnqueueReadBuffer(device_.queue, buffers[a].whole, CL_TRUE, 0, bytes, numbers.data(), 0, nullptr, nullptr),
          "results");
    }
    for (const Buffer& b : buffers) {
      if (b.part) clReleaseMemObject(b.part);
      clReleaseMemObject(b.whole);
    }
  }

 private:
  // Memory, and the part of it between the elements that nothing may touch.
  struct Buffer {
    cl_mem whole, part;
    robcogen_gpu_strides strides;
  };

  const Device& device_;
  const StatesFunction& f_;
  std::vector<backend::gpu::StatesKernel> list_;
  cl_program program_ = nullptr;
  std::vector<cl_kernel> kernels_;

  template <class Real>
  cl_mem new_buffer(std::vector<Real>& numbers) const {
    cl_int error = CL_SUCCESS;
    const cl_mem buffer = clCreateBuffer(
        device_.context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, numbers.size() * sizeof(Real), numbers.data(),
        &error);
    check(error, "buffer");
    return buffer;
  }

  template <class Real>
  Buffer buffer(Memory<Real>& memory, std::size_t elements) const {
    const auto [data, layout, stride] = memory.array();
    const int size = static_cast<int>(elements), given = static_cast<int>(stride);
    const cl_mem whole = new_buffer(memory.numbers());
    constexpr std::size_t kBegin = Memory<Real>::kGuard * sizeof(Real);
    const cl_buffer_region region = {kBegin, memory.numbers().size() * sizeof(Real) - kBegin};
    cl_int error = CL_SUCCESS;
    const cl_mem part = clCreateSubBuffer(whole, 0, CL_BUFFER_CREATE_TYPE_REGION, &region, &error);
    check(error, "part of a buffer");
    if (layout == robcogen_gpu_by_tile) return {whole, part, {5, 32 * size, 32}};
    if (layout == robcogen_gpu_by_state) return {whole, part, {0, given, 1}};
    return {whole, part, {0, 1, given}};
  }
};

struct Case {
  std::string robot, group;
  bool has_tiles = false;
  backend::gpu::Lengths lengths = {};
};

// Runs the first function of the group. Returns the first difference from the interpreter. One of the states is NaN.
template <class Real>
std::string differences(
    const Device& device,
    const Library& library,
    const std::filesystem::path& folder,
    const Case& c,
    const std::vector<int>& counts) {
  const std::string prefix = library.name + "_gpu";
  const backend::gpu::Names names = backend::gpu::names(library, c.lengths);
  const StatesFunction f = backend::gpu::states_functions(names, c.group).front();
  std::string options = sizeof(Real) == 8 ? " -DROBCOGEN_GPU_DOUBLE" : "";
  if (c.has_tiles) options += " -DROBCOGEN_GPU_TILES";
  const Kernels kernels(device, f, folder, prefix + "/" + c.group + "_kernels.h", prefix + "_kernel_", options);
  const backend::Function& function = *f.function->function;
  std::mt19937_64 engine(7);
  const int most = *std::max_element(counts.begin(), counts.end());
  const States<Real> states = random_states<Real>(library, function.program, most, engine);
  std::vector<robcogen_gpu_layout> layouts = {robcogen_gpu_by_element, robcogen_gpu_by_state, robcogen_gpu_by_tile};
  if (c.has_tiles) layouts = {robcogen_gpu_by_tile};
  for (const int count : counts) {
    std::vector<Memory<Real>> memory = memory_of(f, states, static_cast<std::size_t>(count), layouts);
    kernels.run(count, memory);
    for (std::size_t a = 0; a < memory.size(); ++a)
      if (const std::string wrong =
              difference(memory[a], states.arrays[a], static_cast<std::size_t>(count), tolerance<Real>(function));
          !wrong.empty())
        return f.name + " of " + std::to_string(count) + ": " + f.arrays[a].array.name + wrong;
  }

  // A NaN in the inputs of state 1 makes no other state worse.
  std::vector<Memory<Real>> memory = memory_of(f, states, 4, layouts);
  memory[0].at(1, 1) = std::numeric_limits<Real>::quiet_NaN();
  kernels.run(4, memory);
  const std::size_t result = memory.size() - 1;
  bool has_nan = false;
  for (std::size_t k = 0; k < f.arrays[result].size; ++k) {
    has_nan = has_nan || std::isnan(memory[result].at(k, 1));
    memory[result].at(k, 1) = states.arrays[result][1][k];
  }
  const std::string wrong = difference(memory[result], states.arrays[result], 4, tolerance<Real>(function));
  return (has_nan ? "" : f.name + ": NaN had no effect; ") + wrong;
}

class OpenCl : public testing::Test {
 protected:
  void SetUp() override {
    if (device().queue) return;
    if (ROBCOGEN_REQUIRE_ORACLES) FAIL() << "no device of OpenCL: install pocl-opencl-icd";
    GTEST_SKIP() << "no device of OpenCL";
  }
  static Device& device() {
    static Device one;
    return one;
  }
  static Library library(const Case& c) {
    return library_of(kRobots / c.robot / (c.robot + ".kindsl"), c.robot, std::nullopt, {}, {c.group}, kGpuFeatures);
  }
};

TEST_F(OpenCl, ALegInDoubleWithMixedLayouts) {
  const Case leg = {"hyl", "joint_space_inertia"};
  const Library robot = library(leg);
  const Scratch scratch("gpu-opencl-leg");
  write_gpu(scratch.path, robot);
  EXPECT_EQ(differences<double>(device(), robot, scratch.path, leg, {1, 31, 32, 33, 1000}), "");

  const std::filesystem::path file = scratch.path / "hyl_gpu" / "joint_space_inertia.h";
  std::string text = read_text(file);
  text[text.find(" - ") + 1] = '+';
  write_text(file, text);
  EXPECT_NE(differences<double>(device(), robot, scratch.path, leg, {1}), "") << "a wrong sign was not found";
}

// Stages that pass numbers, and stages that solve for columns.
TEST_F(OpenCl, ALegInStages) {
  const Case leg = ROBCOGEN_TEST_EVERYTHING ? Case{"geared_leg", "forward_dynamics_derivatives", false, {1000, 300}}
                                            : Case{"hyl", "forward_dynamics", false, {60, 40}};
  const Library robot = library(leg);
  const Scratch scratch("gpu-opencl-stages");
  write_gpu(scratch.path, robot, leg.lengths);
  ASSERT_NE(
      read_text(scratch.path / (leg.robot + "_gpu") / (leg.group + "_kernels.h")).find("_stage2("), std::string::npos);
  EXPECT_EQ(differences<float>(device(), robot, scratch.path, leg, {33}), "");
}

TEST_F(OpenCl, AnArmInFloatWithTiles) {
  const Case arm = {"iiwa14", "forward_dynamics", true};
  const Library robot = library(arm);
  const Scratch scratch("gpu-opencl-arm");
  write_gpu(scratch.path, robot);
  EXPECT_EQ(differences<float>(device(), robot, scratch.path, arm, {1, 31, 32, 33, 1000}), "");
}

}  // namespace
}  // namespace robcogen::test
