// The text for GPUs, run by an implementation of OpenCL (PoCL: on the processor), gives the interpreter's results.
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <gtest/gtest.h>

#include <cstdlib>

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

// A kernel of the text in a folder.
class Kernel {
 public:
  Kernel(
      const Device& device,
      const std::filesystem::path& folder,
      const std::string& header,
      const std::string& name,
      const std::string& options)
      : device_(device) {
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
    kernel_ = clCreateKernel(program_, name.c_str(), &error);
    check(error, name.c_str());
  }
  ~Kernel() {
    clReleaseKernel(kernel_);
    clReleaseProgram(program_);
  }
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;

  // Computes `count` states. More threads than states run, in groups of 32.
  template <class Real>
  void run(const StatesFunction& f, int count, std::vector<Memory<Real>>& memory) const {
    std::vector<cl_mem> buffers;
    cl_uint argument = 0;
    check(clSetKernelArg(kernel_, argument++, sizeof(count), &count), "count");
    for (std::size_t a = 0; a < memory.size(); ++a) {
      std::vector<Real>& numbers = memory[a].numbers();
      cl_int error = CL_SUCCESS;
      const cl_mem whole = clCreateBuffer(
          device_.context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, numbers.size() * sizeof(Real), numbers.data(),
          &error);
      check(error, "buffer");
      constexpr std::size_t kBegin = Memory<Real>::kGuard * sizeof(Real);
      const cl_buffer_region region = {kBegin, numbers.size() * sizeof(Real) - kBegin};
      const cl_mem part = clCreateSubBuffer(whole, 0, CL_BUFFER_CREATE_TYPE_REGION, &region, &error);
      check(error, "part of a buffer");
      check(clSetKernelArg(kernel_, argument++, sizeof(part), &part), "array");
      const auto [data, layout, stride] = memory[a].array();
      const int size = static_cast<int>(f.arrays[a].size), given = static_cast<int>(stride);
      const cl_int strides[3] = {
          layout == robcogen_gpu_by_tile ? 5 : 0,
          layout == robcogen_gpu_by_tile    ? 32 * size
          : layout == robcogen_gpu_by_state ? given
                                            : 1,
          layout == robcogen_gpu_by_tile      ? 32
          : layout == robcogen_gpu_by_element ? given
                                              : 1};
      check(clSetKernelArg(kernel_, argument++, sizeof(strides), strides), "strides");
      buffers.insert(buffers.end(), {whole, part});
    }
    const std::size_t local = 32, global = (static_cast<std::size_t>(count) + 32) / 32 * 32;
    check(clEnqueueNDRangeKernel(device_.queue, kernel_, 1, nullptr, &global, &local, 0, nullptr, nullptr), "start");
    check(clFinish(device_.queue), "run");
    for (std::size_t a = 0; a < memory.size(); ++a) {
      std::vector<Real>& numbers = memory[a].numbers();
      check(
          clEnqueueReadBuffer(
              device_.queue, buffers[2 * a], CL_TRUE, 0, numbers.size() * sizeof(Real), numbers.data(), 0, nullptr,
              nullptr),
          "results");
      clReleaseMemObject(buffers[2 * a + 1]);
      clReleaseMemObject(buffers[2 * a]);
    }
  }

 private:
  const Device& device_;
  cl_program program_ = nullptr;
  cl_kernel kernel_ = nullptr;
};

struct Case {
  std::string robot, group;
  bool has_tiles = false;
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
  const backend::gpu::Names names = backend::c::names(library, prefix, prefix);
  const StatesFunction f = backend::gpu::states_functions(names, c.group).front();
  std::string options = sizeof(Real) == 8 ? " -DROBCOGEN_GPU_DOUBLE" : "";
  if (c.has_tiles) options += " -DROBCOGEN_GPU_TILES";
  const Kernel kernel(device, folder, prefix + "/" + c.group + "_kernels.h", prefix + "_kernel_" + f.name, options);
  const backend::Function& function = *f.function->function;
  std::mt19937_64 engine(7);
  const int most = *std::max_element(counts.begin(), counts.end());
  const States<Real> states = random_states<Real>(library, function.program, most, engine);
  std::vector<robcogen_gpu_layout> layouts = {robcogen_gpu_by_element, robcogen_gpu_by_state, robcogen_gpu_by_tile};
  if (c.has_tiles) layouts = {robcogen_gpu_by_tile};
  for (const int count : counts) {
    std::vector<Memory<Real>> memory = memory_of(f, states, static_cast<std::size_t>(count), layouts);
    kernel.run(f, count, memory);
    for (std::size_t a = 0; a < memory.size(); ++a)
      if (const std::string wrong =
              difference(memory[a], states.arrays[a], static_cast<std::size_t>(count), tolerance<Real>(function));
          !wrong.empty())
        return f.name + " of " + std::to_string(count) + ": " + f.arrays[a].array.name + wrong;
  }

  // A NaN in the inputs of state 1 makes no other state worse.
  std::vector<Memory<Real>> memory = memory_of(f, states, 4, layouts);
  memory[0].at(1, 1) = std::numeric_limits<Real>::quiet_NaN();
  kernel.run(f, 4, memory);
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

TEST_F(OpenCl, AnArmInFloatWithTiles) {
  const Case arm = {"iiwa14", "forward_dynamics", true};
  const Library robot = library(arm);
  const Scratch scratch("gpu-opencl-arm");
  write_gpu(scratch.path, robot);
  EXPECT_EQ(differences<float>(device(), robot, scratch.path, arm, {1, 31, 32, 33, 1000}), "");
}

}  // namespace
}  // namespace robcogen::test
