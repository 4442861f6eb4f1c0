/* The selected language applies to all tabs of all pages that offer it. */
const KEY = "corridor.docs.language";
const radios = [...document.querySelectorAll(".tabs input")];

function choose(language) {
  for (const radio of radios) if (radio.value === language) radio.checked = true;
}

/* Without storage, the selection applies to this page only. */
function stored() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function store(language) {
  try {
    localStorage.setItem(KEY, language);
  } catch {
    // The selection is not stored.
  }
}

/* The address can name a block: its tab is selected, without storing the selection. */
function openNamedBlock() {
  const panel = document.getElementById(location.hash.slice(1))?.closest(".panel");
  const tabs = panel?.closest(".tabs");
  if (!tabs) return;
  const panels = [...tabs.querySelectorAll(".panel")];
  tabs.querySelectorAll("input")[panels.indexOf(panel)].checked = true;
  tabs.scrollIntoView();
}

choose(stored());
openNamedBlock();
addEventListener("hashchange", openNamedBlock);
for (const radio of radios) {
  radio.addEventListener("change", () => {
    // Blocks above may change their height: keep the position of the selected tab.
    const before = radio.getBoundingClientRect().top;
    choose(radio.value);
    scrollBy(0, radio.getBoundingClientRect().top - before);
    store(radio.value);
  });
}
