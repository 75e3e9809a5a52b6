// The style of a page of an exploration (html_report.cc): on a screen, wide or narrow, light or
// dark, and on A4.
#pragma once

#include <string_view>

namespace oncard::explore {

inline constexpr std::string_view kPageStyle =
    R"(:root { color-scheme: light dark; --back: #fff; --text: #1b1f24; --dim: #5d6670; --line: #c9d0d8;
  --panel: #f3f5f8; --statement: #e9f0fb; --good: #0a6b35; --bad: #b3121d; --open: #8a5700; }
@media screen and (prefers-color-scheme: dark) { :root { --back: #14181d; --text: #dde3ea;
  --dim: #95a0ac; --line: #3c4650; --panel: #1d232a; --statement: #1f2f47; --good: #5cc98a;
  --bad: #ff7a80; --open: #e5b567; } }
* { box-sizing: border-box; }
html { font-size: 15px; }
body { margin: 0; background: var(--back); color: var(--text);
  font: 1rem/1.5 system-ui, "Noto Sans CJK SC", "Microsoft YaHei", sans-serif; }
main { max-width: 76rem; margin: 0 auto; padding: 2rem; }
header { border-bottom: 2px solid var(--text); }
h1 { margin: 0; font-size: 1.7rem; overflow-wrap: anywhere; }
h2 { margin: 2rem 0 .6rem; font-size: 1.2rem; border-bottom: 1px solid var(--line); }
h3 { margin: 1.2rem 0 .4rem; font-size: 1rem; }
p, ul { margin: .5rem 0; }
ul { padding-left: 1.3rem; }
.kind { margin: 0; color: var(--dim); }
.verdict { font-size: 1.1rem; margin: .6rem 0 1rem; }
.verdict strong { margin-right: .6rem; }
.PROVED strong, .PASSED strong { color: var(--good); }
.FAILED strong { color: var(--bad); }
.INCOMPLETE strong { color: var(--open); }
code, pre, .steps, .source { font-family: ui-monospace, "DejaVu Sans Mono", Consolas, monospace; font-size: .86rem; }
pre { margin: .5rem 0; padding: .6rem .8rem; background: var(--panel); overflow-x: auto; }
table { border-collapse: collapse; }
th, td { padding: .25rem .8rem .25rem 0; text-align: left; vertical-align: top; }
th { color: var(--dim); font-weight: 600; }
.facts th, .facts td { border-bottom: 1px solid var(--line); }
.facts { width: 100%; }
.facts code { overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
.steps td, .steps th { padding: .1rem .8rem; white-space: pre; }
.steps thead th { border-bottom: 2px solid var(--dim); }
.steps .number, .steps .line { color: var(--dim); text-align: right; }
.steps .statement { background: var(--statement); }
.steps .repeat { color: var(--dim); font-style: italic; }
.steps .escape { border-top: 2px solid var(--bad); }
.steps .time td { color: var(--dim); border-top: 1px solid var(--line); }
.read { color: var(--dim); }
.written { color: var(--good); }
.beside { display: flex; gap: 2rem; align-items: flex-start; flex-wrap: wrap; }
.beside svg { max-width: 100%; height: auto; }
svg text { font: 11px system-ui, sans-serif; fill: currentColor; paint-order: stroke;
  stroke: var(--back); stroke-width: 3px; }
.source td { padding: 0 .8rem 0 0; white-space: pre; }
.source td:nth-child(-n+2) { color: var(--dim); text-align: right; }
.source .missed td { background: var(--panel); }
@media (max-width: 600px) { main { padding: 1rem; } h1 { font-size: 1.3rem; } }
@media print {
  @page { size: A4; margin: 15mm; }
  html { font-size: 9pt; }
  main { max-width: none; padding: 0; }
  h2, h3 { break-after: avoid; }
  tr, svg { break-inside: avoid; }
  thead { display: table-header-group; }
  .wide { overflow: visible; }
  .steps td, .steps th, .source td, pre { white-space: pre-wrap; overflow-wrap: anywhere; }
  .steps td, .steps th { font-size: 7.5pt; padding: .1rem .3rem; }
  .steps .number, .steps .line, .source td:nth-child(-n+2) { white-space: nowrap; }
  .beside { display: block; }
}
)";

}  // namespace oncard::explore
