// The search of every page.
"use strict";

function found(asked) {
  const words = asked.toLowerCase().split(/\s+/).filter(Boolean);
  const score = (entry) => {
    const text = `${entry.id} ${entry.label} ${entry.title} ${entry.paper}`.toLowerCase();
    const numbers = entry.numbers.map((number) => number.toLowerCase());
    const exact = words.some((word) => numbers.includes(word.replace(".", "")));
    const all = words.every((word) => numbers.includes(word.replace(".", "")) || (/^[a-z]?\.?\d+$/.test(word) ? false : text.includes(word)));
    return all ? 1 + exact : 0;
  };
  return words.length ? ENTRIES.filter(score).sort((a, b) => score(b) - score(a)).slice(0, 40) : [];
}

document.addEventListener("DOMContentLoaded", () => {
  const input = document.querySelector(".search input");
  const list = document.querySelector(".search ul");
  input.addEventListener("input", () => {
    list.replaceChildren(...found(input.value).map((entry) => {
      const item = document.createElement("li");
      const link = item.appendChild(document.createElement("a"));
      link.href = entry.page;
      link.textContent = `${entry.label} · ${entry.paper} · ${entry.title}`;
      return item;
    }));
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") list.querySelector("a")?.click();
    if (event.key === "Escape") list.replaceChildren();
  });
});
