// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every report has: how it looks, and how its tables sort themselves.
#pragma once

namespace plenum::study {

inline constexpr const char* pageStyle = R"(
body { font: 15px/1.5 system-ui, sans-serif; color: #222; max-width: 76rem; margin: 2rem auto;
  padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
svg { max-width: 100%; height: auto; }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13px; }
th, td { padding: .25rem .6rem; border-bottom: 1px solid #ddd; text-align: right;
  white-space: nowrap; }
td.text, th.text { text-align: left; }
th { cursor: pointer; background: #f4f4f4; position: sticky; top: 0; }
th[aria-sort=ascending]::after { content: " \25b2"; }
th[aria-sort=descending]::after { content: " \25bc"; }
tr:hover td { background: #eef5fb; }
figure { display: inline-block; margin: .5rem 1rem .5rem 0; width: 22rem; vertical-align: top; }
figure img { max-width: 100%; } figcaption { font-size: 13px; }
@media print { th { position: static; } }
)";

/// A click on a column's name sorts by it, another one turns the order round; the address
/// #sort=COLUMN or #sort=-COLUMN (from 1) shows it so.
inline constexpr const char* pageScript = R"(
function sortBy(head, descending) {
  const table = head.closest("table"), body = table.tBodies[0];
  const column = Array.from(head.parentNode.children).indexOf(head);
  const value = row => row.cells[column].textContent.trim();
  const isText = head.classList.contains("text");
  const rows = Array.from(body.rows);
  rows.sort((a, b) => {
    const x = value(a), y = value(b);
    if (x === "" || y === "") return (x === "") - (y === "");
    const order = isText ? x.localeCompare(y) : Number(x) - Number(y);
    return descending ? -order : order;
  });
  body.append(...rows);
  for (const other of head.parentNode.children) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", descending ? "descending" : "ascending");
}
for (const head of document.querySelectorAll("th"))
  head.addEventListener("click", () =>
    sortBy(head, head.getAttribute("aria-sort") === "ascending"));
function sortAsAddress() {
  const asked = location.hash.match(/^#sort=(-?)(\d+)$/);
  const heads = document.querySelectorAll("th");
  if (asked && heads[asked[2] - 1]) sortBy(heads[asked[2] - 1], asked[1] === "-");
}
addEventListener("hashchange", sortAsAddress);
sortAsAddress();
)";

}  // namespace plenum::study
