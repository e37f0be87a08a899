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

// Heß, Hess and hess, half-space and half space, pull_off and pull off are the same to a reader
function folded(text) {
  return String(text).toLowerCase().replaceAll("ß", "ss").normalize("NFD").replace(/\p{M}/gu, "").replace(/[-_–]/g, " ");
}

function misses(text, parts) {
  return folded(text).split(/[\s.,]+/).filter((word) => word && !parts.some((part) => word.startsWith(part))).length;
}

// the key itself first, then names of profiles and labels with the fewest words that nobody asked for
function rank([key, profile, system, label], query, parts) {
  const { profiles, systems } = window.axicontact;
  if (key.toLowerCase() === query) return -2;
  if (key.toLowerCase().startsWith(query)) return -1;
  const words = folded(label).split(/[\s.,]+/);
  const asked = words.some((word) => parts.some((part) => word.startsWith(part)));
  const meant = parts.some((part) => folded(systems[system].join(" ")).includes(part));
  return 10 * misses(profiles[profile][0], parts) + (asked ? misses(label, parts) : 9) - (meant ? 5 : 0);
}

function search(text) {
  const query = text.trim().toLowerCase();
  const parts = folded(query).split(/\s+/).filter(Boolean);
  if (!parts.length) return [];
  const { profiles, systems, keys } = window.axicontact;
  const found = keys.filter(([key, profile, system, label, names]) => {
    const words = folded([key, profile, ...profiles[profile], ...systems[system], label, names].join(" "));
    return parts.every((part) => words.includes(part) || (part.length > 5 && words.replaceAll(" ", "").includes(part)));
  });
  const ranks = new Map(found.map((row) => [row, rank(row, query, parts)]));
  return found.sort((a, b) => ranks.get(a) - ranks.get(b));
}

function show(list, rows) {
  const { profiles, systems } = window.axicontact;
  list.replaceChildren(...rows.slice(0, SHOWN).map((row) => {
    const [key, profile, system, label] = row;
    const item = document.createElement("li");
    item.id = `found.${key}`;
    const link = document.createElement("a");
    const small = document.createElement("small");
    link.href = address(row);
    link.className = "hit";
    link.textContent = key;
    small.textContent = `${label} · ${profiles[profile][0]} · ${systems[system][0]}`;
    link.append(small);
    item.setAttribute("role", "option");
    item.append(link);
    return item;
  }));
  list.hidden = rows.length === 0;
  document.getElementById("q").setAttribute("aria-expanded", String(!list.hidden));
}

function hide(list) {
  list.hidden = true;
  document.getElementById("q").setAttribute("aria-expanded", "false");
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
    if (event.key === "Escape") hide(list);
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    const items = [...list.children];
    const now = items.findIndex((item) => item.classList.contains("chosen"));
    const next = Math.max(0, Math.min(items.length - 1, now + (event.key === "ArrowDown" ? 1 : -1)));
    items.forEach((item, i) => item.classList.toggle("chosen", i === next));
    if (items[next]) input.setAttribute("aria-activedescendant", items[next].id);
    items[next]?.scrollIntoView({ block: "nearest" });
  });
  document.addEventListener("click", (event) => { if (!event.target.closest(".search")) hide(list); });
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
