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

// cone of cone.html
const ENTRY = location.pathname.split("/").pop().replace(/\.html$/, "");

function cited(row) {
  const key = `${ENTRY}.${row.id}`;
  return window.axicontact.citation.replace("KEY", key).replace("NAME", key.replaceAll("_", "\\_"));
}

function copied(row, kind) {
  if (kind === "bibtex") return cited(row);
  if (kind === "python") return [...row.querySelectorAll("pre")].map((pre) => pre.textContent).join("\n\n");
  return [...row.querySelectorAll(".line .tex")].map((tex) => tex.dataset.latex).join("\n");
}

async function writeClipboard(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {  // no clipboard without a secure context, or none allowed
    const place = document.activeElement;
    const area = document.createElement("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
    place.focus({ preventScroll: true });
  }
}

let silence = 0;

// said beside the search, and by a screen reader
function tell(text, milliseconds = 0) {
  const place = document.getElementById("told");
  clearTimeout(silence);
  place.textContent = text;
  if (milliseconds) silence = setTimeout(() => { place.textContent = ""; }, milliseconds);
}

document.addEventListener("click", async (event) => {
  const button = event.target.closest("button.copy");
  if (!button) return;
  const row = button.closest(".row");
  await writeClipboard(copied(row, button.dataset.kind));
  tell(`copied: ${button.textContent} of ${row.id}`, 2500);
  button.classList.add("done");
  setTimeout(() => button.classList.remove("done"), 2500);
});

// the curves of a figure in the units of its axes, each point with the name of its curve
function table(figure) {
  const { x, y, logx, logy } = figure.dataset;
  const number = (text, log) => (log === undefined ? text : String(Number((10 ** text).toPrecision(4))));
  const rows = [...figure.querySelectorAll(".window polyline")].flatMap((line) => (
    line.getAttribute("points").split(" ").map((point) => {
      const [right, up] = point.split(",");
      return [line.dataset.name, number(right, logx), number(up, logy)];
    })
  ));
  const quoted = (text) => `"${text.replaceAll('"', '""')}"`;
  return [["curve", x, y].map(quoted), ...rows.map(([name, ...point]) => [quoted(name), ...point])].join("\r\n");
}

function offerTables() {
  for (const figure of document.querySelectorAll("figure:has(.window)")) {
    const link = document.createElement("a");
    link.href = `data:text/csv;charset=utf-8,${encodeURIComponent(table(figure))}`;
    link.download = `${ENTRY}.${figure.id.replace("plot.", "")}.csv`;
    link.className = "table";
    link.textContent = "CSV";
    link.setAttribute("aria-label", `CSV of the curves: ${figure.querySelector("b").textContent}`);
    figure.querySelector("figcaption").append(" ", link);
  }
}

// a button leaves the pictures of its kind, and the headings of those
function startFilter() {
  const buttons = [...document.querySelectorAll(".filter button")];
  for (const button of buttons) {
    button.parentElement.hidden = false;
    button.addEventListener("click", () => {
      const { kind } = button.dataset;
      for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
      for (const group of document.querySelectorAll(".group")) {
        const cards = [...group.querySelectorAll("[data-kinds]")];
        for (const card of cards) card.hidden = Boolean(kind) && !card.dataset.kinds.split(" ").includes(kind);
        group.hidden = cards.every((card) => card.hidden);
      }
    });
  }
}

// opens what the target of the address lies in, and goes there
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  for (let fold = target.closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true;
  target.scrollIntoView();
}

// Heß, Hess and hess, half-space and half space, pull_off and pull off, p(r) and p r are the same to a reader
function folded(text) {
  const plain = String(text).toLowerCase().replaceAll("ß", "ss").normalize("NFD").replace(/\p{M}/gu, "");
  return plain.replace(/[^\p{L}\p{N}*]+/gu, " ").trim();
}

// the names of a hit, the more they count the earlier they stand, and what is shown of it
function indexed() {
  const { profiles, systems, keys, places, first } = window.axicontact;
  const formulas = keys.map(([key, profile, system, label, names]) => ({
    name: key,
    address: `${profile}.html#${key.slice(profile.length + 1)}`,
    words: `${label} · ${profiles[profile][0]} · ${systems[system][0]}`,
    fields: [
      `${key.slice(profile.length + 1)} ${label}`, profiles[profile][0], `${profile} ${names}`, systems[system].join(" "),
      profiles[profile][1],
    ],
    wanted: label,
    title: profiles[profile][0],
    unnamed: first.includes(profile) ? 0 : 4,
    behind: 0,
  }));
  const others = places.map(([title, address, also, behind]) => ({
    name: title, address, words: `${also} · ${address}`, fields: [title, "", also], wanted: title, title: "", unnamed: 0, behind,
  }));
  return [...formulas, ...others].map((hit) => {
    const fields = hit.fields.map(folded);
    return {
      ...hit, fields: fields.map((field) => field.split(" ")), joined: fields.join("").replaceAll(" ", ""),
      wanted: [...new Set(folded(hit.wanted).split(" "))], title: folded(hit.title).split(" ").filter(Boolean),
      folded: folded(hit.name),
    };
  });
}

// how far a word of the query is from a hit; short words are no part of others, as p is none of depth
function distance(hit, part) {
  let least = Infinity;
  hit.fields.forEach((words, place) => {
    for (const word of words) {
      const off = word === part ? 0 : word.startsWith(part) ? 3 : part.length > 2 && word.includes(part) ? 6 : Infinity;
      least = Math.min(least, off + 2 * place);
    }
  });
  return least === Infinity && part.length > 5 && hit.joined.includes(part) ? 12 : least;
}

// the key itself first, then the ends of keys, then hits with the fewest words that nobody asked for;
// where no profile is asked for, the first ones come first
function score(hit, query, parts) {
  if (hit.name === query && (query.includes(".") || !hit.behind)) return -30;
  if (!hit.behind && hit.folded === parts.join(" ")) return -20;
  if (query.includes(".") && hit.name.toLowerCase().startsWith(query.toLowerCase())) return -10;
  const asked = (word) => parts.some((part) => word === part || (part.length > 1 && word.startsWith(part)));
  const far = parts.reduce((sum, part) => sum + distance(hit, part), hit.behind);
  const rest = (words) => words.filter((word) => !asked(word)).length;
  const extra = rest(hit.wanted) + (hit.title.some(asked) ? rest(hit.title) : hit.unnamed);
  return far + extra - (hit.name.endsWith(`.${query.replace(/^\./, "")}`) ? 4 : 0);
}

let index = null;

function split(text) {
  const query = text.trim().replace(/(\p{L})\([^)]*\)/gu, "$1");  // p(r) is p
  return [query, folded(query).split(" ").filter(Boolean)];
}

function search(text) {
  const [query, parts] = split(text);
  if (!parts.length) return [];
  index ??= indexed();
  const found = index.map((hit) => [score(hit, query, parts), hit]).filter(([far]) => far < Infinity);
  return found.sort(([one], [other]) => one - other).map(([, hit]) => hit);
}

// whether one letter is wrong, missing, too many or changed with its neighbour
function misspelt(word, right) {
  if (word === right) return false;
  let i = 0;
  while (word[i] === right[i]) i += 1;
  const rest = (text, from) => text.slice(i + from);
  if (rest(word, 1) === rest(right, 1) || rest(word, 0) === rest(right, 1) || rest(word, 1) === rest(right, 0)) return true;
  return word[i] === right[i + 1] && word[i + 1] === right[i] && rest(word, 2) === rest(right, 2);
}

// the query with each word that is nowhere in the index spelt as the commonest one beside it; "" if there is none
function guess(text) {
  const parts = split(text)[1];
  index ??= indexed();
  const unknown = (part) => !index.some((hit) => distance(hit, part) < Infinity);
  const counts = new Map();
  for (const word of index.flatMap((hit) => hit.fields.flat())) counts.set(word, (counts.get(word) ?? 0) + 1);
  const right = (part) => {
    const near = [...counts.keys()].filter((word) => /^\p{L}{4,}$/u.test(word) && misspelt(part, word));
    return near.sort((one, other) => counts.get(other) - counts.get(one))[0];
  };
  const guessed = parts.map((part) => (unknown(part) ? right(part) : part));
  return guessed.includes(undefined) ? "" : guessed.join(" ");
}

function show(list, hits, said) {
  list.replaceChildren(...hits.slice(0, SHOWN).map((hit, i) => {
    const item = document.createElement("li");
    item.id = `found.${i}`;
    const link = document.createElement("a");
    const small = document.createElement("small");
    link.href = hit.address;
    link.className = "hit";
    link.tabIndex = -1;  // reached by the arrows
    link.textContent = hit.name;
    small.textContent = hit.words;
    link.append(small);
    item.setAttribute("role", "option");
    item.setAttribute("aria-selected", "false");
    item.append(link);
    return item;
  }));
  open(list, hits.length > 0);
  tell(said);
}

// what is found, or else what is found of the same words spelt right
function update(input, list) {
  const asked = input.value.trim();
  const hits = search(asked);
  if (hits.length || !asked) return show(list, hits, "");
  const meant = guess(asked);
  const others = search(meant);
  const advice = others.length ? `did you mean ${meant}?` : "try a key such as cone.p, a profile or a quantity";
  return show(list, others, `nothing found for ${asked}: ${advice}`);
}

function open(list, shown) {
  const input = document.getElementById("q");
  list.hidden = !shown;
  input.setAttribute("aria-expanded", String(shown));
  if (!shown) input.removeAttribute("aria-activedescendant");
}

function choose(input, list, step) {
  if (list.hidden) return open(list, list.children.length > 0);
  const items = [...list.children];
  const now = items.findIndex((item) => item.classList.contains("chosen"));
  const next = Math.max(0, Math.min(items.length - 1, now + step));
  items.forEach((item, i) => {
    item.classList.toggle("chosen", i === next);
    item.setAttribute("aria-selected", String(i === next));
  });
  input.setAttribute("aria-activedescendant", items[next].id);
  items[next].scrollIntoView({ block: "nearest" });
}

function startSearch() {
  const input = document.getElementById("q");
  const list = document.getElementById("found");
  const leave = () => { open(list, false); tell(""); };
  input.addEventListener("input", () => update(input, list));
  input.form.addEventListener("submit", (event) => {
    event.preventDefault();
    const first = list.querySelector("li.chosen a") ?? list.querySelector("a");
    if (!first) return;
    leave();
    location.href = first.href;
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape" || event.key === "Tab") leave();
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    choose(input, list, event.key === "ArrowDown" ? 1 : -1);
  });
  list.addEventListener("click", leave);
  document.addEventListener("click", (event) => { if (!event.target.closest(".search, button.copy")) leave(); });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && document.activeElement !== input) { event.preventDefault(); input.focus(); }
  });
  input.value = new URLSearchParams(location.search).get("q") ?? "";
  update(input, list);
}

renderFormulas();
startSearch();
startFilter();
offerTables();
reveal();  // the formulas have changed the height of everything above the target
addEventListener("hashchange", reveal);
document.addEventListener("click", (event) => {
  if (event.target.closest('a[href^="#"]')) setTimeout(reveal);  // also where the address stays
});
