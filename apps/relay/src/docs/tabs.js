/* The language that a reader chooses counts for every block of every page that offers it. */
const KEY = "corridor.docs.language";
const radios = [...document.querySelectorAll(".tabs input")];

function choose(language) {
  for (const radio of radios) if (radio.value === language) radio.checked = true;
}

/* Where the browser stores nothing, the choice counts for this page. */
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
    // The page does without.
  }
}

choose(stored());
for (const radio of radios) {
  radio.addEventListener("change", () => {
    // Blocks above may get longer or shorter: the one that was chosen in stays where it is.
    const before = radio.getBoundingClientRect().top;
    choose(radio.value);
    scrollBy(0, radio.getBoundingClientRect().top - before);
    store(radio.value);
  });
}
