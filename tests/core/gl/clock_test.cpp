// The GPU clock, which relief bench uses if there is a GPU.
#include <gtest/gtest.h>

#include "framework/core/gl/gl.h"
#include "framework/core/gl/target.h"
#include "framework/staff/measure/run.h"

namespace relief {
namespace {

TEST(GpuClock, MeasuresDrawTimeInSeconds) {
    const Target target(TargetKind::probe, {1024, 1024});
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    const auto clear = [] { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), glFinish(); };
    double gpu = 0;
    const double wall = measure::by_wall_clock([&] { gpu = measure::by_gpu_clock(clear, 20); }, 1);
    EXPECT_GT(gpu, 0);
    EXPECT_LE(gpu, wall) << "seconds, and no other unit";
    EXPECT_TRUE(take_gl_errors().empty());
}

}  // namespace
}  // namespace relief
