// relief gallery: the course as a web site, with every lab's methods side by side, its handout, slides and
// measurements. It needs no network and no server: all links stay in its folder.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <list>
#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/from_staff.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/core/lab/words.h"
#include "framework/course/app/gallery.h"
#include "framework/course/manifest/paths.h"
#include "framework/course/pages/handout_page.h"
#include "framework/course/pages/lab_groups.h"
#include "framework/course/pages/lab_page.h"
#include "framework/course/pages/method_comparison.h"
#include "framework/course/pages/page.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

/// Returns the value of a knob as words: "level 4", "vertex normal".
std::string value_in_words(const std::string& knob, const std::string& value) {
    if (value.empty() || !std::isalpha(static_cast<unsigned char>(value.front()))) return knob + " " + value;
    std::string words = value;
    std::replace(words.begin(), words.end(), '-', ' ');
    return words;
}

/// Returns the pictures of a lab's methods, one after the other on its card, if the lab is one of those whose methods
/// differ at a glance. They are the pictures of the lab's page.
pages::Value turning(const pages::LabPage& page) {
    constexpr std::array at_a_glance = {1, 10, 13, 15};
    if (std::find(at_a_glance.begin(), at_a_glance.end(), page.lab->number) == at_a_glance.end()) return {};
    pages::List frames;
    for (const pages::LabPage::Method& method : page.methods)
        frames.push_back(pages::Fields{{"picture", method.picture}, {"name", value_in_words(page.knob, method.name)}});
    if (frames.size() < 2) return {};
    return pages::Fields{{"count", frames.size()}, {"frames", std::move(frames)}};
}

pages::Fields card(const pages::LabPage& page) {
    const Manifest& manifest = *page.manifest;
    const size_t tasks = manifest.tasks.size();
    const std::string file = pages::lab_page_file(*page.lab);
    return {{"broken", ""},
            {"number", page.lab->two_digits()},
            {"title", manifest.title},
            {"file", file},
            {"live", tasks == 0 ? "" : page.live},
            {"elective", manifest.elective},
            {"picture", page.card},
            {"turning", turning(page)},
            {"learns", pages::List(manifest.learns.begin(), manifest.learns.end())},
            {"tasks", tasks == 0 ? ""
                                 : fmt::format("{}{} {}, {}", manifest.elective ? "elective: " : "", tasks,
                                               tasks == 1 ? "task" : "tasks", points_of_lab(manifest))}};
}

/// Converts a knob's value to a part of a file name.
std::string as_file_name(const std::string& value) {
    std::string name;
    for (const char c : value) name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' ? c : '-';
    return name;
}

/// The output of another command below the build folder, if any, to be copied into the site.
class Others {
public:
    Others(const char* name, const fs::path& site) : name_(name), to_(site / name) {
        const fs::path from = course_root() / "build" / name;
        std::error_code none;
        if (!fs::is_directory(from, none)) return;
        for (const auto& entry : fs::recursive_directory_iterator(from))
            if (entry.is_regular_file()) files_.emplace_back(entry.path().lexically_relative(from));
        from_ = from;
    }

    bool has(const std::string& file) const { return std::find(files_.begin(), files_.end(), file) != files_.end(); }
    /// Returns the path of a file in the site, or "" if it does not exist.
    std::string place(const std::string& file) const { return has(file) ? name_ + "/" + file : ""; }
    /// Copies the files. `with_links` changes the text of their first page.
    void copy(const std::function<std::string(std::string page)>& with_links) const {
        for (const fs::path& file : files_) {
            make_folder((to_ / file).parent_path());
            const std::string text = read_file(from_ / file);
            write_file(to_ / file, file == "index.html" ? with_links(text) : text);
        }
    }

private:
    std::string name_;
    fs::path to_, from_;
    std::vector<fs::path> files_;
};

class Site {
public:
    Site(fs::path folder, std::vector<const LabEntry*> labs, bool is_live)
        : folder_(std::move(folder)), labs_(std::move(labs)), is_live_(is_live) {
        if (!is_live)
            for (const char* name : {"slides", "bench", "quiz"}) others_.try_emplace(name, name, folder_);
    }

    /// Makes a page with one picture for each lab, which takes seconds, and calls `ready`. Then adds handouts and
    /// comparisons, lab by lab, which takes minutes. A page of an earlier run stays until its lab is complete. Returns
    /// the number of broken labs.
    int make(const std::function<void()>& ready) {
        for_each_lab("first picture of lab", [&](const LabEntry& lab) { open(lab); });
        link_neighbours();
        draw_hero();
        for (const auto& [name, other] : others_)
            other.copy([&](const std::string& page) { return with_links(page, "../"); });
        write_file(folder_ / "accessibility.html", with_links(accessibility()));
        if (has_sources()) write_file(folder_ / sources_page, with_links(pages::text_page(sources_text, labs_)));
        std::error_code ignored;
        for (const pages::LabPage& page : pages_)
            if (!fs::exists(folder_ / pages::lab_page_file(*page.lab), ignored)) write(page);
        const bool is_first_run = !fs::exists(folder_ / "index.html", ignored);
        if (is_first_run) write_index();
        ready();
        for_each_lab("lab", [&](const LabEntry& lab) {
            pages::LabPage* const page = page_of(lab);
            if (!page) return;
            complete(*page);
            write(*page);
            if (is_first_run) write_index();
        });
        write_index();
        say_what_is_missing();
        return int(broken_.size());
    }

private:
    static constexpr const char *sources_text = "labs/staff/SHOWN.md", *sources_page = "sources.html";
    bool has_sources() const { return !is_live_ && fs::exists(course_root() / sources_text); }

    std::string put(const std::string& name, const Image& image) const {
        pages::write_beside_page(folder_ / name, encode_image(image, ImageFormat::png));
        return name;
    }

    /// Calls visit(lab). An error makes the lab broken, and the others go on.
    void for_each_lab(const char* what, const std::function<void(const LabEntry&)>& visit) {
        Progress progress(int(labs_.size()));
        for (const LabEntry* lab : labs_) {
            progress.next(fmt::format("{} {}", what, lab->two_digits()));
            try {
                visit(*lab);
            } catch (const pages::CannotWrite&) {
                throw;
            } catch (const Error& error) {
                print_error(fmt::format("{}: {}", lab->folder, error.what()));
                broken_[lab] = error.what();
            }
        }
    }

    /// Adds a lab with the picture with which it opens, in both of its sizes.
    void open(const LabEntry& entry) {
        const Manifest& manifest = manifests_.emplace_back(load_manifest(entry));
        pages::LabPage page;
        page.lab = &entry, page.manifest = &manifest;
        Shot shot;
        shot.camera = manifest.camera, shot.size = {800, 450}, shot.studio = true;
        page.card = page.picture = put(entry.folder + ".png", render_shot(*make_lab(entry, shot), shot));
        if (is_live_) {
            page.live = pages::live_page_file(entry);
        } else {
            page.slides = others_.at("slides").place(entry.folder + ".html");
            page.slides_to_print = others_.at("slides").place(entry.folder + ".pdf");
            page.bench = others_.at("bench").place("index.html");
        }
        pages_.push_back(std::move(page));
    }

    void complete(pages::LabPage& page) const {
        const auto comparison = pages::compare_methods(*page.lab, *page.manifest);
        page.card = put(page.lab->folder + "-card.png", cover_of(*page.lab, *page.manifest, {640, 360}));
        if (comparison) add(*comparison, page);
        page.handout = add_handout(*page.lab, *page.manifest);
    }

    pages::LabPage* page_of(const LabEntry& lab) {
        const auto page =
            std::find_if(pages_.begin(), pages_.end(), [&](const pages::LabPage& one) { return one.lab == &lab; });
        return page == pages_.end() ? nullptr : &*page;
    }

    void write(const pages::LabPage& page) const {
        write_file(folder_ / pages::lab_page_file(*page.lab), with_links(pages::lab_page(page)));
    }
    void write_index() {
        pages::List cards;
        for (const LabEntry* lab : labs_)
            if (const auto why = broken_.find(lab); why != broken_.end())
                cards.push_back(
                    pages::Fields{{"broken", why->second}, {"number", lab->two_digits()}, {"title", lab->name}});
            else
                cards.push_back(card(*page_of(*lab)));
        write_file(folder_ / "index.html", index(std::move(cards)));
    }

    /// Draws the lab's cover, because many labs open with all methods at once. The card has its words.
    static Image cover_of(const LabEntry& entry, const Manifest& manifest, glm::ivec2 size) {
        Shot shot;
        shot.camera = manifest.camera;
        if (!manifest.cover.empty()) shot = manifest.golden(manifest.cover).shot;
        std::vector<PictureWord> left_out;
        shot.probe = {}, shot.size = size, shot.words = &left_out, shot.studio = true;
        return render_shot(*make_lab(entry, shot), shot);
    }

    /// Draws the picture of the first page: the course's richest scene, or else the last lab's.
    void draw_hero() {
        constexpr int richest = 16;
        if (pages_.empty()) return;
        auto page = std::find_if(pages_.begin(), pages_.end(),
                                 [](const pages::LabPage& one) { return one.lab->number == richest; });
        if (page == pages_.end()) page = std::prev(pages_.end());
        hero_ = pages::Fields{{"file", pages::lab_page_file(*page->lab)},
                              {"picture", put("hero.png", cover_of(*page->lab, *page->manifest, {1280, 480}))},
                              {"number", page->lab->two_digits()},
                              {"title", page->manifest->title}};
    }

    void add(const pages::Comparison& comparison, pages::LabPage& page) const {
        page.knob = comparison.knob;
        const Image& first = comparison.methods.front().picture;
        page.size = {first.width, first.height};
        if (comparison.probe) {
            page.probe = comparison.probe->name;
            Shot shot = comparison.measured;
            shot.probe = {};
            page.command = fmt::format("./relief shot {} --error {} {}", page.lab->two_digits(), page.probe,
                                       shot_text(shot, page.manifest->camera));
            for (const double part : {1000, 100, 10}) page.marks.push_back(rounded(comparison.max / part));
            page.marks.push_back(amount_of(comparison.max, comparison.probe->unit));
        }
        for (const pages::ComparedMethod& method : comparison.methods) {
            const std::string name = page.lab->folder + "/" + as_file_name(comparison.knob + "-" + method.name);
            pages::LabPage::Method& shown = page.methods.emplace_back();
            shown.name = method.name, shown.picture = put(name + ".png", method.picture);
            if (!method.error) continue;
            page.map_size = {method.error->width, method.error->height};
            shown.error_map = put(name + "-error.png", pages::error_map(comparison.max, *method.error));
            const double mean = method.summary.mean;
            shown.error = mean > 0 && mean < 1e-6 ? "under 0.000001 " + plural(comparison.probe->unit)
                                                  : amount_of(mean, comparison.probe->unit);
        }
    }

    std::string add_handout(const LabEntry& entry, const Manifest& manifest) const {
        if (!fs::exists(course_root() / "labs" / entry.folder / "README.md")) return {};
        const auto put = [&](const std::string& name, const std::string& bytes) {
            pages::write_beside_page(folder_ / name, bytes);
        };
        // A student's unfinished code would draw another picture.
        const bool is_solved = fs::is_directory(course_root() / "framework/staff");
        const auto draw = [&](const GoldenInfo& golden) -> std::optional<pages::WordlessPicture> {
            if (!is_solved || golden.shot.probe) return {};
            std::vector<PictureWord> words;
            Shot shot = golden.shot;
            shot.words = &words, shot.studio = true;
            Image image = render_shot(*make_lab(entry, shot), shot);
            return pages::WordlessPicture{std::move(image), std::move(words)};
        };
        put(pages::handout_file(entry), with_links(pages::handout_page(entry, manifest, labs_, put, draw)));
        return pages::handout_file(entry);
    }

    void link_neighbours() {
        for (auto page = pages_.begin(); page != pages_.end(); ++page) {
            if (page != pages_.begin()) page->previous = &*std::prev(page);
            if (std::next(page) != pages_.end()) page->next = &*std::next(page);
        }
    }

    std::string index(pages::List cards) const {
        size_t tasks = 0;
        int points = 0;
        for (const pages::LabPage& page : pages_)
            tasks += page.manifest->tasks.size(), points += page.manifest->points() + page.manifest->optional_points();
        return pages::render(
            {.title = "Relief: the labs",
             .body = "index",
             .styles = {"site", "index"},
             .scripts = is_live_ ? std::vector<std::string>{"index", "progress"} : std::vector<std::string>{"index"},
             .pictures = pages::PagePictures::beside},
            {{"hero", hero_},
             {"labs", labs_.size()},
             {"labs_word", labs_.size() == 1 ? "lab" : "labs"},
             {"tasks", tasks},
             {"points", points},
             {"begin", begin()},
             {"links", links()},
             {"paths", paths()},
             {"groups", in_groups(std::move(cards))},
             {"driver", describe_context().driver()}});
    }

    /// Returns the link to the first lab that is not broken.
    pages::Value begin() const {
        if (pages_.empty()) return {};
        const pages::LabPage& first = pages_.front();
        return pages::Fields{{"file", pages::lab_page_file(*first.lab)},
                             {"number", first.lab->two_digits()},
                             {"title", first.manifest->title}};
    }

    static void add_link(pages::List& links, const char* name, const std::string& place) {
        if (!place.empty()) links.push_back(pages::Fields{{"name", name}, {"place", place}});
    }
    /// Returns the links of the first page.
    pages::List links() const {
        pages::List links;
        if (!pages_.empty()) add_link(links, "Try in a browser", pages_.front().live);
        for (pages::Value& link : links_everywhere()) links.push_back(std::move(link));
        if (!is_live_ && pages_.size() == registry().size()) add_link(links, "Ways through the course", "#paths");
        return links;
    }
    pages::List links_everywhere() const {
        pages::List links;
        if (is_live_) return links;
        add_link(links, "Speed and error", others_.at("bench").place("index.html"));
        add_link(links, "Which mistake made this picture?", others_.at("quiz").place("index.html"));
        add_link(links, "Where each source is shown", has_sources() ? sources_page : "");
        return links;
    }
    /// Puts the links of the whole site at the top of a page. `top`: the way from the page's folder to the site's.
    std::string with_links(std::string page, const char* top = "") const {
        constexpr std::string_view body = "<body>\n";
        if (const size_t at = page.find(body); at != std::string::npos)
            page.insert(at + body.size(), pages::render("everywhere", {{"top", top}, {"links", links_everywhere()}}));
        return page;
    }

    /// Returns the ways through the course, if all labs are on this site.
    pages::Value paths() const {
        if (pages_.size() < registry().size()) return pages::rows(pages::List());
        std::vector<const Manifest*> labs;
        for (const pages::LabPage& page : pages_) labs.push_back(page.manifest);
        pages::List list;
        double all_hours = 0;
        for (const Manifest* lab : labs) all_hours += lab->hours;
        for (const CoursePath& path : course_paths) {
            const std::vector<CourseWeek> all = weeks_of(path, labs);
            double hours = 0;
            pages::List weeks;
            for (const CourseWeek& week : all) {
                if (week.labs.empty()) break;
                pages::List steps;
                for (const size_t lab : week.labs) {
                    const pages::LabPage& page = *std::next(pages_.begin(), std::ptrdiff_t(lab));
                    steps.push_back(pages::Fields{{"file", pages::lab_page_file(*page.lab)},
                                                  {"number", page.lab->two_digits()},
                                                  {"title", page.manifest->title}});
                }
                weeks.push_back(pages::Fields{{"hours", hours_text(week.hours)}, {"steps", std::move(steps)}});
                hours += week.hours;
            }
            if (weeks.size() < all.size()) continue;
            list.push_back(pages::Fields{
                {"path", path.title}, {"hours", hours_text(hours)}, {"weeks", pages::rows(std::move(weeks))}});
        }
        list.push_back(pages::Fields{{"path", "Everything"}, {"hours", hours_text(all_hours)}, {"weeks", ""}});
        return pages::rows(std::move(list));
    }

    static std::string accessibility() {
        return pages::render({.title = "Relief: accessibility",
                              .body = "accessibility",
                              .styles = {"site", "markdown"},
                              .scripts = {},
                              .pictures = pages::PagePictures::beside},
                             {});
    }

    /// Groups `cards`, which are in the order of the labs.
    pages::List in_groups(pages::List cards) const {
        pages::List all;
        for (const pages::LabGroup& group : pages::lab_groups) {
            const pages::LabGroup* const next = &group + 1 == std::end(pages::lab_groups) ? nullptr : &group + 1;
            pages::List own;
            for (size_t i = 0; i < cards.size(); ++i)
                if (labs_[i]->number >= group.first && (!next || labs_[i]->number < next->first))
                    own.push_back(std::move(cards[i]));
            if (!own.empty())
                all.push_back(pages::Fields{
                    {"name", group.name}, {"title", group.title}, {"about", group.about}, {"cards", std::move(own)}});
        }
        return all;
    }

    void say_what_is_missing() const {
        std::vector<std::string> missing;
        if (!staff_is_here() || is_live_) return;
        if (std::none_of(pages_.begin(), pages_.end(), [](const pages::LabPage& page) { return !page.slides.empty(); }))
            missing.emplace_back("slides");
        if (!others_.at("bench").has("index.html")) missing.emplace_back("measurements");
        if (!others_.at("quiz").has("index.html")) missing.emplace_back("questions about mistakes");
        if (!missing.empty())
            print_note(fmt::format("the site has no {}: ./relief site, in {}, makes all", join(missing, " and no "),
                                   course_root().string()));
    }

    fs::path folder_;
    std::vector<const LabEntry*> labs_;
    bool is_live_;
    std::map<std::string, Others> others_;  ///< slides, measurements, questions; none if the site is live
    pages::Value hero_;
    std::map<const LabEntry*, std::string> broken_;  ///< with the reason
    std::list<Manifest> manifests_;                  ///< pages point to these and to each other
    std::list<pages::LabPage> pages_;
};

}  // namespace

int make_gallery(GalleryOptions options) {
    fs::path& folder = options.folder;
    if (folder.empty()) folder = course_root() / "build" / "gallery";
    std::vector<const LabEntry*> chosen;
    if (options.labs.empty())
        for (const LabEntry& entry : registry()) chosen.push_back(&entry);
    else
        chosen = find_labs(options.labs);
    make_folder(folder);
    const int failures = Site(folder, chosen, options.is_live).make([&] {
        if (options.is_live) return;  // its caller has more to make
        fmt::print("{}\n", fs::absolute(folder / "index.html").lexically_normal().string());
        std::fflush(stdout);
    });
    return failures == 0 ? 0 : 1;
}

class GalleryCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.value("-o", "FOLDER", output_, "folder for the site [the course's build/gallery]");
        options.value("--labs", "LABS", labs_, "like 1-5 or 1,3,10-12 [all]");
        options.value("--context", "NAME", context_, context_help);
    }
    int run() override {
        const auto context = open_context(context_kind(context_));
        return make_gallery({.folder = output_, .labs = labs_});
    }

private:
    std::string output_, labs_, context_ = "auto";
};
RELIEF_COMMAND(GalleryCommand, 5, "gallery",
               "makes the course's web site: each lab with its methods side by side and its handout");

}  // namespace relief::app
