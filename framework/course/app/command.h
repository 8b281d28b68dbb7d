// A command of the command line. It declares its options, and its own file registers it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/context/context.h"

namespace relief::app {

/// A command's options, declared once: the command line parses them, and --help shows them. Numbers are strings, so
/// that the command itself can explain a wrong value.
class CommandOptions {
public:
    virtual ~CommandOptions() = default;
    /// Declares the lab: a number, a name or the beginning of a word in one. An executable with one lab uses that lab
    /// and needs no argument.
    virtual void lab(std::string& value, bool required) = 0;
    /// Declares words without a dash before them.
    virtual void words(const char* name, std::vector<std::string>& values, const char* help) = 0;
    virtual void word(const char* name, std::string& value, const char* help) = 0;
    /// `name` is "-o" or "--size"; `type` stands for the value in the help. If given twice, the last one counts.
    virtual void value(const char* name, const char* type, std::string& value, const char* help) = 0;
    /// An option that may be given several times, one value each.
    virtual void values(const char* name, const char* type, std::vector<std::string>& values, const char* help) = 0;
    virtual void flag(const char* name, bool& value, const char* help) = 0;
    /// Sets the text at the end of --help.
    virtual void footer(std::function<std::string()> text) = 0;
};

class Command {
public:
    virtual ~Command() = default;
    virtual void options(CommandOptions& options) = 0;
    /// Returns the exit code. Throws Error, or UsageError for wrong use.
    virtual int run() = 0;
};

using ContextChoice = std::optional<ContextKind>;  ///< empty: OSMesa, then EGL
constexpr const char* context_help = "auto (osmesa, then egl), osmesa, egl, gpu (egl, hardware only) or window";

struct CommandEntry {
    int order;  ///< in --help: below 10 for students, below 20 for teachers, then for those who maintain the course
    const char *name, *help;
    std::unique_ptr<Command> (*make)();
};

/// Returns all commands of this program in that order.
const std::vector<CommandEntry>& commands();
bool has_command(const std::string& name);

/// Registers a command in commands(). Use RELIEF_COMMAND to define one.
struct CommandRegistration {
    explicit CommandRegistration(CommandEntry entry);
};

#define RELIEF_COMMAND(Type, order, name, help)                             \
    static const ::relief::app::CommandRegistration registration_of_##Type( \
        {order, name, help, [] { return std::unique_ptr<::relief::app::Command>(std::make_unique<Type>()); }})

}  // namespace relief::app
