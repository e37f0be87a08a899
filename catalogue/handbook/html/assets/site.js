"use strict";

const MACROS = { "\\textmu": "$\\mathrm{\\mu}$" };
const SHOWN = 30;

function renderFormulas() {
  for (const place of document.querySelectorAll(".tex")) {
    const latex = place.textContent;
    place.dataset.latex = latex;
    try {
      katex.render(latex, place, { displayMode: "display" in place.dataset, macros: MACROS, strict: "error" });
    } catch (error) {
      place.textContent = latex;
      place.classList.add("failed");
      console.error(`${location.pathname}: ${error.message}`);
    }
  }
}

function copied(row, kind) {
  if (kind === "python") return [...row.querySelectorAll("pre")].map((pre) => pre.textContent).join("\n\n");
  return [...row.querySelectorAll(".line .tex")].map((tex) => tex.dataset.latex).join("\n");
}

async function writeClipboard(text) {
  if (navigator.clipboard && window.isSecureContext) return navigator.clipboard.writeText(text);
  const area = document.createElement("textarea");
  area.value = text;
  document.body.append(area);
  area.select();
  document.execCommand("copy");
  area.remove();
}

document.addEventListener("click", async (event) => {
  const button = event.target.closest("button.copy");
  if (!button) return;
  await writeClipboard(copied(button.closest(".row"), button.dataset.kind));
  button.classList.add("done");
  setTimeout(() => button.classList.remove("done"), 1200);
});

function address([key, profile]) {
  return `${profile}.html#${key.slice(profile.length + 1)}`;
}

function rank(row, query) {
  if (row[0] === query) return 0;
  if (row[0].startsWith(query)) return 1;
  return row[1].startsWith(query) ? 2 : 3;
}

function search(text) {
  const query = text.trim().toLowerCase();
  const parts = query.split(/\s+/).filter(Boolean);
  if (!parts.length) return [];
  const { profiles, systems, keys } = window.axicontact;
  const all = keys.map((row) => {
    const [key, profile, system, label, names] = row;
    return [row, [key, ...profiles[profile], systems[system], label, names].join(" ").toLowerCase()];
  });
  const found = all.filter(([, words]) => parts.every((part) => words.includes(part))).map(([row]) => row);
  return found.sort((a, b) => rank(lowered(a), query) - rank(lowered(b), query));
}

function lowered(row) {
  return row.map((cell) => String(cell).toLowerCase());
}

function show(list, rows) {
  const { profiles, systems } = window.axicontact;
  list.replaceChildren(...rows.slice(0, SHOWN).map((row) => {
    const [key, profile, system, label] = row;
    const item = document.createElement("li");
    const link = document.createElement("a");
    const small = document.createElement("small");
    link.href = address(row);
    link.className = "hit";
    link.textContent = key;
    small.textContent = `${label} · ${profiles[profile][0]} · ${systems[system]}`;
    link.append(small);
    item.append(link);
    return item;
  }));
  list.hidden = rows.length === 0;
}

function startSearch() {
  const input = document.getElementById("q");
  const list = document.getElementById("found");
  const update = () => show(list, search(input.value));
  input.addEventListener("input", update);
  input.form.addEventListener("submit", (event) => {
    event.preventDefault();
    const first = list.querySelector("li.chosen a, a");
    if (first) location.href = first.href;
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape") list.hidden = true;
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    const items = [...list.children];
    const now = items.findIndex((item) => item.classList.contains("chosen"));
    const next = Math.max(0, Math.min(items.length - 1, now + (event.key === "ArrowDown" ? 1 : -1)));
    items.forEach((item, i) => item.classList.toggle("chosen", i === next));
    items[next]?.scrollIntoView({ block: "nearest" });
  });
  document.addEventListener("click", (event) => { if (!event.target.closest(".search")) list.hidden = true; });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && document.activeElement !== input) { event.preventDefault(); input.focus(); }
  });
  input.value = new URLSearchParams(location.search).get("q") ?? "";
  update();
}

renderFormulas();
startSearch();
// the formulas have changed the height of everything above the target
if (location.hash) document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
