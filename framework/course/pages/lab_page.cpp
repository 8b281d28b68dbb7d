#include "framework/course/pages/lab_page.h"

#include "framework/course/manifest/paths.h"
#include "framework/course/pages/figures.h"
#include "framework/course/pages/page.h"

namespace relief::pages {
namespace {

Value compared(const LabPage& page) {
    if (page.methods.empty()) return {};
    List methods;
    for (const LabPage::Method& method : page.methods)
        methods.push_back(Fields{{"name", method.name},
                                 {"picture", method.picture},
                                 {"error_map", method.error_map},
                                 {"error", method.error},
                                 {"is_first", &method == &page.methods.front()},
                                 {"is_last", &method == &page.methods.back()}});
    const bool has_maps = !page.methods.front().error_map.empty();
    return Fields{{"knob", page.knob},
                  {"probe", has_maps ? page.probe : ""},
                  {"command", page.command},
                  {"scale", has_maps ? error_scale(page.marks) : Value()},
                  {"width", page.size.x},
                  {"height", page.size.y},
                  {"map_width", page.map_size.x},
                  {"map_height", page.map_size.y},
                  {"last", methods.back()},
                  {"methods", methods}};
}

Value tasks(const Manifest& manifest) {
    List list;
    for (const TaskInfo& task : manifest.tasks)
        list.push_back(
            Fields{{"id", task.id}, {"title", task.title}, {"optional", task.optional}, {"points", task.points}});
    return rows(std::move(list));
}

Value neighbour(const LabPage* to) {
    if (!to) return {};
    return Fields{{"file", lab_page_file(*to->lab)}, {"number", to->lab->two_digits()}, {"title", to->manifest->title}};
}

}  // namespace

Value link_row(const std::vector<std::pair<std::string, std::string>>& links) {
    List list;
    for (const auto& [name, place] : links)
        if (!place.empty()) list.push_back(Fields{{"name", name}, {"place", place}});
    return rows(std::move(list));
}

std::string lab_page_file(const LabEntry& lab) { return lab.folder + ".html"; }

std::string live_page_file(const LabEntry& lab) { return lab.folder + "-live.html"; }

std::string lab_page(const LabPage& page) {
    const std::string number = page.lab->two_digits();
    const Manifest& manifest = *page.manifest;
    Page frame{.title = "Lab " + number + ": " + manifest.title,
               .body = "lab",
               .styles = {"figures", "site", "lab"},
               .scripts = {},
               .pictures = PagePictures::beside};
    if (!page.methods.empty()) frame.scripts = {"wipe", "lab"};
    return render(frame, {{"number", number},
                          {"title", manifest.title},
                          {"picture", page.picture},
                          {"points", manifest.points()},
                          {"optional_points", manifest.optional_points() > 0},
                          {"effort", manifest.hours > 0 ? effort_text(manifest) : ""},
                          {"learns", rows(manifest.learns)},
                          {"tasks", tasks(manifest)},
                          {"compared", compared(page)},
                          {"previous", neighbour(page.previous)},
                          {"next", neighbour(page.next)},
                          {"links", link_row({{"Try in a browser", page.live},
                                              {"Handout", page.handout},
                                              {"Slides", page.slides},
                                              {"Slides as PDF", page.slides_to_print},
                                              {"Speed and error", page.bench}})}});
}

}  // namespace relief::pages
