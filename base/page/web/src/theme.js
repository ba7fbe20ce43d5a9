/* Light, dark and print: which one holds, and the colours that are painted by script. */

const KEY = "umbra-theme";
const listeners = new Set();
const media = matchMedia("(prefers-color-scheme: dark)");
const printing = matchMedia("print");
let choice = "auto";
let printed = false;

const LIGHT = {
  dark: false,
  ink: "#1d2328", soft: "#5a646d", faint: "#8a949c", grid: "rgba(29,35,40,0.09)", axis: "rgba(29,35,40,0.28)", surface: "#ffffff",
  edge: "#20262b",
  series: ["#0072b2", "#d55e00", "#009e73", "#c0569a", "#b07c00", "#2f8fc7", "#6b5b95", "#6e6e6e"],
  before: "#8a949c",
  shade: { umbra: "rgba(49,66,102,0.20)", penumbra: "rgba(49,66,102,0.09)", night: "rgba(90,60,140,0.15)", twilight: "rgba(90,60,140,0.07)" },
  shades: ["rgba(176,124,0,0.12)", "rgba(0,158,115,0.10)", "rgba(192,86,154,0.10)"],
  arrows: { sun: "#b07c00", nadir: "#0072b2", observer: "#007a59", velocity: "#b0458a" },
};

const DARK = {
  dark: true,
  ink: "#e8ebee", soft: "#a3adb6", faint: "#79848d", grid: "rgba(232,235,238,0.09)", axis: "rgba(232,235,238,0.28)", surface: "#171b20",
  edge: "#0c0f12",
  series: ["#4fb3ef", "#ff8a4a", "#2fc79b", "#e58cc3", "#e8b33a", "#9bd3f7", "#b3a2e0", "#b5bcc2"],
  before: "#8a949c",
  shade: { umbra: "rgba(140,165,225,0.20)", penumbra: "rgba(140,165,225,0.10)", night: "rgba(180,150,240,0.17)", twilight: "rgba(180,150,240,0.08)" },
  shades: ["rgba(232,179,58,0.14)", "rgba(47,199,155,0.12)", "rgba(229,140,195,0.12)"],
  arrows: { sun: "#ffcc4d", nadir: "#6cc0f5", observer: "#2fc79b", velocity: "#e58cc3" },
};

/** The colours that hold now; paper is light. */
export function colours() {
  return isDark() ? DARK : LIGHT;
}

export function isDark() {
  if (isPrinting()) return false;
  return choice === "dark" || (choice === "auto" && media.matches);
}

export function isPrinting() {
  return printed || printing.matches;
}

/** What the reader chose: auto, light or dark. */
export function themeChoice() {
  return choice;
}

function apply() {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  for (const f of listeners) f();
}

/** Sets and keeps the reader's choice. Where nothing can be kept (file: pages may forbid it) it holds for this page. */
export function chooseTheme(value) {
  choice = value;
  try {
    localStorage.setItem(KEY, value);
  } catch {
    /* nothing is kept */
  }
  apply();
}

/** Calls `f` whenever colours or the medium change; gives back what ends that. */
export function onTheme(f) {
  listeners.add(f);
  return () => listeners.delete(f);
}

export function startTheme() {
  try {
    choice = localStorage.getItem(KEY) ?? "auto";
  } catch {
    choice = "auto";
  }
  media.addEventListener("change", apply);
  printing.addEventListener("change", apply);
  addEventListener("beforeprint", () => {
    printed = true;
    apply();
  });
  addEventListener("afterprint", () => {
    printed = false;
    apply();
  });
  apply();
}
