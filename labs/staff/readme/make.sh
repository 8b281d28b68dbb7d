#!/usr/bin/env bash
# Makes the README's pictures beside this file, from the programs in build/bin: terminal.svg, a recording of two
# commands on a lab with a known mistake, and three pictures of the window. Needs Perl, Xvfb, xdotool and xwd.
set -euo pipefail
here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
root=$(cd -- "$here/../../.." && pwd)
course=$(mktemp -d) # the mistake is made in a copy, with the programs in it
server= window=
trap '[[ -z $window ]] || kill "$window"; [[ -z $server ]] || kill "$server"; rm -rf "$course"' EXIT
mkdir -p "$course/framework/course" "$course/bin"
cp -r "$root"/{labs,shaders,assets} "$course"
cp -r "$root/framework/course/pages" "$course/framework/course"
cp -r "$root"/build/bin/{textures,relief,lab-*,relief-*.so,librelief.so,librelief-truth.so} "$course/bin"
cat >"$course/relief" <<'END'
#!/bin/sh
exec "$(dirname "$0")/bin/relief" "$@"
END
chmod +x "$course/relief"

# Prints a command as a user types it, and the first lines of its output on a terminal with colours.
columns=122
show() { # command, lines
  printf '$ %s\n' "$1"
  (cd "$course" && TERM=xterm script -qec "stty cols $columns; $1" /dev/null </dev/null | tr -d '\r' | head -n "$2") || true
  echo
}

# Turns lines into an SVG in which they appear one after the other. All of them stand there without animations.
as_svg() {
  perl -e '
    my ($columns, $letter, $step, $edge) = (shift, 8, 19, 16);
    chomp(my @lines = <STDIN>);
    pop @lines while @lines && $lines[-1] =~ /^\s*$/;
    my ($wide, $high) = ($columns * $letter + 2 * $edge, @lines * $step + 2 * $edge);
    print qq{<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 $wide $high" font-family="ui-monospace, },
          qq{DejaVu Sans Mono, monospace" font-size="13.3" fill="#e8e6e1">\n<title>relief check and relief explain in },
          qq{a terminal</title>\n<style>\@keyframes show { from { opacity: 0 } } g { animation: show 0.01s both }\n},
          qq{\@media (prefers-reduced-motion: reduce) { g { animation: none } }</style>\n},
          qq{<rect width="$wide" height="$high" rx="10" fill="#16171b"/>\n};
    my ($at, $y) = (0.3, $edge - 5);
    my %color = (31 => "#ff8a7a", 32 => "#7fd18b", 33 => "#f0c060");
    for my $line (@lines) {
      $y += $step;
      my $typed = $line =~ /^\$ /;
      $at += $typed ? 0.9 : 0.07;
      next if $line eq "";
      my ($x, $fill, $spans) = ($edge, $typed ? "#9cc4ff" : "#e8e6e1", "");
      for my $part (split /(\e\[[0-9;]*m)/, $line) {
        if ($part =~ /^\e\[([0-9;]*)m/) { $fill = $color{$1} // "#e8e6e1"; next }
        my $length = length $part;
        next if !$length;
        my $width = $length * $letter;
        $part =~ s/&/&amp;/g; $part =~ s/</&lt;/g;
        $spans .= qq{<text x="$x" y="$y" fill="$fill" textLength="$width" xml:space="preserve">$part</text>} if $part =~ /\S/;
        $x += $width;
      }
      printf qq{<g style="animation-delay: %.2fs">%s</g>\n}, $at, $spans;
      $at += 0.8 if $typed;
    }
    print "</svg>\n";
  ' "$columns"
}

# Writes a picture of the screen as PNG.
take() { # file
  xwd -root -silent -display "$DISPLAY" | perl -MCompress::Zlib -e '
    local $/;
    my $all = <STDIN>;
    my @header = unpack "N25", $all;
    my ($width, $height, $line) = @header[4, 5, 12];
    my $at = $header[0] + 12 * $header[19];
    my $rows = "";
    for my $y (0 .. $height - 1) {
      my $row = substr $all, $at + $y * $line, 4 * $width;
      $row =~ s/(.)(.)(.)./$3$2$1/gs;  # blue, green, red
      $rows .= "\0" . $row;
    }
    sub chunk { my ($name, $data) = @_; pack("N", length $data) . $name . $data . pack "N", crc32($name . $data) }
    binmode STDOUT;
    print "\x89PNG\r\n\x1a\n", chunk("IHDR", pack "NNC5", $width, $height, 8, 2, 0, 0, 0),
          chunk("IDAT", compress($rows, 9)), chunk("IEND", "");
  ' >"$1"
}

picture_of_window() { # file, seconds, keys, arguments of relief run
  (cd "$course" && exec bin/relief run "${@:4}") &
  window=$!
  xdotool mousemove 1279 799 # no values of a pixel are shown there
  sleep "$2"
  for key in $3; do
    xdotool search --onlyvisible --name '^Relief: ' windowfocus key "$key"
    sleep 2
  done
  take "$here/$1"
  kill "$window"
  wait "$window" || true
  window=
}

export LIBGL_ALWAYS_SOFTWARE=1 WAYLAND_DISPLAY=
seconds=${1:-20} # until the checks have run; more on a slow machine
exec {number}<> <(:)
Xvfb -displayfd "$number" -screen 0 1280x800x24 -nolisten tcp -noreset &
server=$!
read -r -u "$number" display
export DISPLAY=:$display

picture_of_window window_picture.png "$seconds" '' 14
picture_of_window window_error_map.png "$seconds" '' 11 --set view=one --error-map
sed -i 's|code / 255.0 \* 2.0 - 1.0|code / 256.0 * 2.0 - 1.0|' "$course/shaders/02_normal_map_storage/task.glsl"
picture_of_window window_check.png "$seconds" '' 02 --check 'three bytes and back'
{
  show './relief check 02' 8
  show "$(cd "$course" && ./relief check 02 | grep -om1 './relief explain .*')" 12 # of the worst pixel
} | as_svg >"$here/terminal.svg"
