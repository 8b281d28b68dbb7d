// The editor of a lab's page: CodeMirror 6 with GLSL or C++. Bundled when the site is made.
import {EditorView, basicSetup} from "codemirror";
import {keymap} from "@codemirror/view";
import {indentWithTab} from "@codemirror/commands";
import {HighlightStyle, StreamLanguage, indentUnit, syntaxHighlighting} from "@codemirror/language";
import {cpp, shader} from "@codemirror/legacy-modes/mode/clike";
import {setDiagnostics} from "@codemirror/lint";
import {tags} from "@lezer/highlight";

// The colours of the site. A shadow root takes the page's variables.
const look = EditorView.theme({
  "&": {height: "100%", fontSize: "13px", color: "var(--text)"},
  "&.cm-focused": {outline: "2px solid var(--accent)", outlineOffset: "-2px"},
  ".cm-scroller": {fontFamily: "ui-monospace, monospace", lineHeight: "1.45"},
  ".cm-gutters": {background: "var(--code)", color: "var(--quiet)", border: "0"},
  ".cm-content": {caretColor: "var(--text)"},
  ".cm-cursor": {borderLeftColor: "var(--text)"},
  ".cm-activeLine, .cm-activeLineGutter": {background: "transparent"},
  // Instead of a picture in the style sheet, which the page's policy forbids.
  ".cm-lintRange-error": {backgroundImage: "none", textDecoration: "underline wavy var(--bad)"},
  ".cm-panels, .cm-tooltip": {background: "var(--card)", color: "var(--text)", borderColor: "var(--edge)"},
});
const colors = HighlightStyle.define([
  {tag: tags.comment, color: "var(--quiet)"},
  {tag: [tags.keyword, tags.typeName, tags.standard(tags.variableName)], color: "var(--accent)"},
  {tag: tags.number, color: "var(--peer)"},
  {tag: tags.meta, color: "var(--good)"},
]);

// Puts an editor into an element, and calls `changed` after each change by the user. It has a shadow root, so that its
// style sheets obey the page's policy.
window.openEditor = (place, text, changed, language) => {
  const root = place.attachShadow({mode: "open"});
  const view = new EditorView({
    doc: text, root, parent: root,
    extensions: [
      basicSetup, keymap.of([indentWithTab]), indentUnit.of("    "), StreamLanguage.define(language === "C++" ? cpp : shader), look,
      EditorView.lineWrapping,
      syntaxHighlighting(colors),
      EditorView.contentAttributes.of({"aria-label": "task file: press Escape, then Tab, to leave the editor"}),
      EditorView.updateListener.of(update => { if (update.docChanged) changed(view.state.doc.toString()); }),
    ],
  });
  view.scrollDOM.tabIndex = 0;
  return {
    text: () => view.state.doc.toString(),
    replace: whole => {
      view.dispatch({changes: {from: 0, to: view.state.doc.length, insert: whole}});
    },
    // Marks a line with a compiler's message; none if there is no message.
    mark: (line, message) => {
      const marks = [];
      if (message) {
        const {from, to} = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
        marks.push({from, to, severity: "error", message});
      }
      view.dispatch(setDiagnostics(view.state, marks));
    },
  };
};
