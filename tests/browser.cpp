#include "tests/browser.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

namespace relief {
namespace {

using nlohmann::json;

/// A browser that shares two cores with other tests starts slowly.
constexpr int patience_ms = 120'000;

void set_up_and_become_chromium(int reads, int writes, const std::string& profile, const std::string& display) {
    // Its pages draw few pictures: see optimize_shaders().
    setenv("GALLIVM_PERF", "nopt", 1);
    setpgid(0, 0);  // so that all its processes can be killed together
    const int null = open("/dev/null", O_RDWR);
    for (const int descriptor : {0, 1, 2}) dup2(null, descriptor);
    // Move them away from 3 and 4 first, which they may be themselves.
    const int in = fcntl(reads, F_DUPFD, 10), out = fcntl(writes, F_DUPFD, 10);
    dup2(in, 3), dup2(out, 4);
    const std::string folder = "--user-data-dir=" + profile;
    std::vector<const char*> words = {"chromium",
                                      "--no-sandbox",
                                      "--remote-debugging-pipe",
                                      "--no-first-run",
                                      "--disable-background-networking",
                                      "--disable-component-update",
                                      "--disable-dev-shm-usage",
                                      folder.c_str()};
    if (display.empty()) {
        words.insert(words.end(), {"--headless=new", "--disable-gpu"});
    } else {
        setenv("DISPLAY", display.c_str(), 1);
        words.insert(words.end(), {"--use-gl=angle", "--use-angle=gl", "--ignore-gpu-blocklist"});
    }
    words.insert(words.end(), {"about:blank", nullptr});
    execvp("chromium", const_cast<char**>(words.data()));
    _exit(127);
}

}  // namespace

Browser::Browser(const std::string& display) {
    int there[2], back[2];
    if (pipe2(there, O_CLOEXEC) != 0 || pipe2(back, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("fork failed");
    if (pid_ == 0) set_up_and_become_chromium(there[0], back[1], profile_.path().string(), display);
    close(there[0]), close(back[1]);
    to_ = there[1], from_ = back[0];
    std::signal(SIGPIPE, SIG_IGN);
    std::string page;
    const json targets = call("Target.getTargets");
    for (const json& target : targets["targetInfos"])
        if (target["type"] == "page") page = target["targetId"];
    session_ = call("Target.attachToTarget", {{"targetId", page}, {"flatten", true}})["sessionId"];
    for (const char* part : {"Page", "Runtime", "Log", "Accessibility", "Network"}) call(std::string(part) + ".enable");
    call("Emulation.setFocusEmulationEnabled", {{"enabled", true}});
    call("Emulation.setDeviceMetricsOverride",
         {{"width", 1280}, {"height", 900}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

Browser::~Browser() {
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    close(to_), close(from_);
}

json Browser::next_message() {
    size_t end = 0;
    while ((end = buffer_.find('\0')) == std::string::npos) {
        pollfd ready{.fd = from_, .events = POLLIN, .revents = 0};
        char bytes[65536];
        const ssize_t count = poll(&ready, 1, patience_ms) == 1 ? read(from_, bytes, sizeof bytes) : -1;
        if (count <= 0)
            throw std::runtime_error("chromium does not answer: is it installed? see framework/cmake/packages.txt");
        buffer_.append(bytes, size_t(count));
    }
    json message = json::parse(buffer_.substr(0, end));
    buffer_.erase(0, end + 1);
    return message;
}

json Browser::call(const std::string& method, const json& parameters) {
    json request = {{"id", ++id_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) request["sessionId"] = session_;
    const std::string text = request.dump() + '\0';
    for (size_t sent = 0; sent < text.size();) {
        const ssize_t count = write(to_, text.data() + sent, text.size() - sent);
        if (count <= 0) break;  // the missing answer reports it
        sent += size_t(count);
    }
    for (;;) {
        json message = next_message();
        if (message.value("id", 0) != id_) {
            events_.push_back(std::move(message));
            continue;
        }
        if (message.contains("error")) throw std::runtime_error(method + ": " + message["error"].dump());
        return message["result"];
    }
}

void Browser::open(const std::filesystem::path& page) {
    std::string address = "file://";
    for (const char c : page.string()) address += c == ' ' ? "%20" : std::string(1, c);
    open_address(address);
}

void Browser::open_address(const std::string& address) {
    events_.clear();
    call("Page.navigate", {{"url", address}});
    const auto loaded = [&] {
        return std::any_of(events_.begin(), events_.end(),
                           [](const json& event) { return event["method"] == "Page.loadEventFired"; });
    };
    while (!loaded()) events_.push_back(next_message());
}

json Browser::eval(const std::string& expression) {
    const json answer = call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}});
    if (answer.contains("exceptionDetails")) throw std::runtime_error(answer["exceptionDetails"].dump(1));
    return answer["result"].value("value", json());
}

json Browser::wait_for(const std::string& expression) {
    // The checks of lab 10 take 20 seconds alone, and minutes beside three other programs on two processors.
    for (int i = 0; i < 6000; ++i) {
        const json value = eval("(() => { const value = " + expression + "; return value || null; })()");
        if (!value.is_null()) return value;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    throw std::runtime_error("never true: " + expression);
}

void Browser::press(const std::string& key, int times) {
    const struct {
        int code;
        const char *name, *text;
    } keys[] = {{9, "Tab", ""},  {13, "Enter", "\r"}, {27, "Escape", ""},    {32, "Space", " "},
                {35, "End", ""}, {36, "Home", ""},    {37, "ArrowLeft", ""}, {39, "ArrowRight", ""}};
    for (const auto& one : keys) {
        if (key != one.name) continue;
        json event = {{"key", key == "Space" ? " " : key}, {"code", key}, {"windowsVirtualKeyCode", one.code}};
        for (int i = 0; i < times; ++i) {
            event["type"] = "keyDown", event["text"] = one.text;
            call("Input.dispatchKeyEvent", event);
            event["type"] = "keyUp", event.erase("text");
            call("Input.dispatchKeyEvent", event);
        }
        return;
    }
    throw std::logic_error("no key " + key);
}

bool Browser::tab_to(const std::string& selector) {
    for (int i = 0; i < 500; ++i) {
        press("Tab");
        if (eval("document.activeElement.matches(" + json(selector).dump() + ")") == true) return true;
    }
    return false;
}

void Browser::type(const std::string& text) { call("Input.insertText", {{"text", text}}); }

void Browser::dark(bool on) {
    call("Emulation.setEmulatedMedia",
         {{"features", {{{"name", "prefers-color-scheme"}, {"value", on ? "dark" : "light"}}}}});
}

void Browser::paper(bool on) {
    width(on ? 720 : 0);
    call("Emulation.setEmulatedMedia", {{"media", on ? "print" : ""}});
}

void Browser::width(int pixels) {
    if (pixels == 0)
        call("Emulation.clearDeviceMetricsOverride");
    else
        call("Emulation.setDeviceMetricsOverride",
             {{"width", pixels}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", true}});
}

bool Browser::load_images() {
    eval("document.images.length && [...document.images].forEach(image => image.loading = 'eager')");
    for (int i = 0; i < 500; ++i) {
        if (eval("[...document.images].every(image => image.complete)") == true)
            return eval("[...document.images].every(image => image.naturalWidth > 0)");
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

void Browser::scripts(bool on) { call("Emulation.setScriptExecutionDisabled", {{"value", !on}}); }

std::vector<Browser::Control> Browser::controls() {
    std::vector<Control> found;
    const json tree = call("Accessibility.getFullAXTree");
    for (const json& node : tree["nodes"]) {
        if (node.value("ignored", false)) continue;
        for (const json& property : node.value("properties", json::array()))
            if (property["name"] == "focusable" && property["value"]["value"] == true)
                found.push_back(
                    {node["role"].value("value", ""), node.contains("name") ? node["name"].value("value", "") : ""});
    }
    return found;
}

namespace {

constexpr const char* faint_texts_script = R"js((() => {
  const numbers = color => color.match(/[\d.]+/g).map(Number);
  const light = color => {
    const linear = v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
    const [r, g, b] = numbers(color).map(v => linear(v / 255));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = element => {
    for (; element; element = element.parentElement) {
      const color = getComputedStyle(element).backgroundColor;
      if ((numbers(color)[3] ?? 1) == 1) return color;
    }
    return "rgb(255, 255, 255)";
  };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), found = new Set();
  let texts = 0;
  while (walker.nextNode()) {
    const text = walker.currentNode.textContent.trim(), element = walker.currentNode.parentElement;
    if (!text || !element.checkVisibility() || ["script", "title", "desc"].includes(element.localName)) continue;
    ++texts;
    const plot = element.closest("svg"), turned = plot && getComputedStyle(plot).filter.match(/invert\(([\d.]+)\)/);
    // What the filter makes of a colour; turning hues leaves its lightness.
    const seen = color => turned
        ? "rgb(" + numbers(color).slice(0, 3).map(v => turned[1] * 255 - (2 * turned[1] - 1) * v).join() + ")" : color;
    const colors = plot ? [getComputedStyle(element).fill, "rgb(255, 255, 255)"].map(seen)
                        : [getComputedStyle(element).color, behind(element)];
    const [a, b] = colors.map(light).sort((a, b) => b - a);
    if ((a + 0.05) / (b + 0.05) < 4.5) found.add(text);
  }
  return texts > 10 ? [...found] : ["there is no text"];
})())js";

/// Finds texts of different elements that cover one another where both are visible.
constexpr const char* covered_texts_script = R"js((() => {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), lines = [], found = new Set();
  const seen = (box, element) => {
    let [left, top, right, bottom] = [box.left, box.top, box.right, box.bottom];
    for (; element && element != document.body; element = element.parentElement) {
      const style = getComputedStyle(element);
      if (style.clipPath != "none") return null;
      if (style.overflowX == "visible" && style.overflowY == "visible") continue;
      const edge = element.getBoundingClientRect();
      left = Math.max(left, edge.left), right = Math.min(right, edge.right);
      top = Math.max(top, edge.top), bottom = Math.min(bottom, edge.bottom);
    }
    return right - left > 2 && bottom - top > 2 ? {left, top, right, bottom} : null;
  };
  while (walker.nextNode()) {
    const text = walker.currentNode.textContent.trim(), element = walker.currentNode.parentElement;
    if (!text || !element.checkVisibility({opacityProperty: true, visibilityProperty: true}) ||
        element.closest("script, style, title, desc, textarea, select, math, .cm-editor")) continue;
    const range = document.createRange();
    range.selectNodeContents(walker.currentNode);
    for (const box of range.getClientRects()) {
      const line = seen(box, element);
      if (line) lines.push({...line, text, element});
    }
  }
  lines.sort((a, b) => a.top - b.top);
  lines.forEach((a, i) => {
    for (let k = i + 1; k < lines.length && lines[k].top < a.bottom; ++k) {
      const b = lines[k], wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const high = Math.min(a.bottom, b.bottom) - b.top;
      if (a.element != b.element && wide > 2 && high > 0.4 * Math.min(a.bottom - a.top, b.bottom - b.top))
        found.add(a.text.slice(0, 60) + " | " + b.text.slice(0, 60));
    }
  });
  return [...found];
})())js";

}  // namespace

std::vector<std::string> Browser::faint_texts() { return eval(faint_texts_script); }

std::vector<std::string> Browser::accessibility_faults() {
    const std::filesystem::path axe = std::filesystem::path(build_folder) / "marp/node_modules/axe-core/axe.min.js";
    std::ifstream file(axe);
    if (!file) throw std::runtime_error(axe.string() + " is missing: ./relief test --ci installs it");
    const std::string script(std::istreambuf_iterator<char>(file), {});
    eval("document.querySelectorAll('details').forEach(one => { one.open = true; })");
    std::set<std::string> found;
    for (const int pixels : {1440, 390})
        for (const bool is_dark : {false, true}) {
            width(pixels), dark(is_dark);
            const json answer = call(
                "Runtime.evaluate",
                {{"expression",
                  script +
                      R"js(;axe.run({rules: {'target-size': {enabled: true}}}).then(result => result.violations.flatMap(rule => rule.nodes.map(node =>
                      rule.id + ": " + node.html.slice(0, 160) + " " + node.failureSummary))))js"},
                 {"returnByValue", true},
                 {"awaitPromise", true}});
            if (answer.contains("exceptionDetails")) throw std::runtime_error(answer["exceptionDetails"].dump(1));
            for (const std::string fault : answer["result"]["value"]) found.insert(fault);
            for (const std::string texts : eval(covered_texts_script)) found.insert("covered text: " + texts);
        }
    width(0), dark(false);
    return {found.begin(), found.end()};
}

std::set<std::string> Browser::requests() {
    std::set<std::string> found;
    for (const json& event : events_)
        if (event["method"] == "Network.requestWillBeSent") found.insert(event["params"]["request"]["url"]);
    return found;
}

std::vector<std::string> Browser::complaints() {
    std::vector<std::string> found;
    for (const json& event : events_)
        if (event["method"] == "Runtime.exceptionThrown" || event["method"] == "Log.entryAdded")
            found.push_back(event["params"].dump());
    return found;
}

}  // namespace relief
