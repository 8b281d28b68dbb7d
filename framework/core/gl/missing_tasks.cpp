#include "framework/core/gl/missing_tasks.h"

#include <utility>

namespace relief {
namespace {
bool told = false;
}

TellMissingTasks::TellMissingTasks(bool tell) : before_(std::exchange(told, tell)) {}
TellMissingTasks::~TellMissingTasks() { told = before_; }

bool missing_tasks_are_told() { return told; }

}  // namespace relief
