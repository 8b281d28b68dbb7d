// relief gallery: a web page with a picture of every lab.
#include <fmt/format.h>

#include "framework/app/commands.h"
#include "framework/app/page.h"
#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/paths.h"
#include "framework/image/file.h"
#include "framework/lab/manifest.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

std::string card(const LabEntry& entry, const Manifest& manifest) {
    std::string learns;
    for (const std::string& line : manifest.learns) learns += fmt::format("<li>{}</li>", html(line));
    return fmt::format(R"(<article id="lab-{0}">
<a href="{1}.png"><img src="{1}.png" alt="{2}" width="1280" height="720"></a>
<div><h2><span class="number">{0}</span> {2}</h2><ul>{3}</ul><code>./relief run {0}</code></div>
</article>
)",
                       entry.two_digits(), entry.folder, html(manifest.title), learns);
}

std::string broken_card(const LabEntry& entry, const std::string& reason) {
    return fmt::format(R"(<article id="lab-{0}" class="broken">
<div><h2><span class="number">{0}</span> {1}</h2><p>No picture: {2}</p></div>
</article>
)",
                       entry.two_digits(), html(entry.name), html(reason));
}

constexpr const char* style = R"(
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 560px), 1fr)); gap: 28px; }
article { background: var(--card); border-radius: 12px; overflow: hidden; }
article img { display: block; width: 100%; height: auto; }
article div { padding: 16px 22px 22px; }
ul { margin: 0 0 12px; padding-left: 20px; color: var(--quiet); }
.broken { border: 1px solid var(--bad); }
)";

constexpr const char* page_top = R"(<header><h1>Relief</h1>
<p>Surface detail in OpenGL, lab by lab: normal maps, tangent spaces, parallax, displacement. Each picture is what the
lab draws when it opens.</p></header>
<main>
)";

}  // namespace

int make_gallery(fs::path folder, ContextChoice choice) {
    if (folder.empty()) folder = course_root() / "build" / "gallery";
    make_folder(folder);
    const auto context = open_context(choice);
    std::string cards;
    int failures = 0;
    Progress progress(int(registry().size()));
    for (const LabEntry& entry : registry()) {
        progress.next("lab " + entry.two_digits());
        Image picture;
        try {
            const Manifest manifest = load_manifest(entry);
            Shot shot;
            shot.camera = manifest.camera;
            picture = take(*make_lab(entry, shot), shot);
            cards += card(entry, manifest);
        } catch (const Error& error) {
            print_error(fmt::format("{}: {}", entry.folder, error.what()));
            cards += broken_card(entry, error.what());
            ++failures;
            continue;
        }
        write_image(folder / (entry.folder + ".png"), picture);  // a folder that cannot be written ends it all
    }
    const std::string footer =
        fmt::format("</main>\n<footer>Rendered by {}.</footer>\n", html(describe_context().driver()));
    const fs::path page = folder / "index.html";
    write_file(page, page_begin("Relief: the labs", style) + page_top + cards + footer + page_end());
    fmt::print("{}\n", fs::absolute(page).lexically_normal().string());
    return failures == 0 ? 0 : 1;
}

}  // namespace relief
