/**
 * Observes changes of the page's colours, texts or fonts: another theme or language, or another
 * system setting.
 */

/** @returns a function that stops observing */
export function observeTheme(onChange: () => void): () => void {
  const root = document.documentElement;
  const observer = new MutationObserver(onChange);
  observer.observe(root, {
    attributes: true,
    attributeFilter: ["data-theme", "data-contrast", "lang"],
  });
  const queries = ["(prefers-color-scheme: dark)", "(forced-colors: active)"].map((query) =>
    window.matchMedia(query),
  );
  for (const query of queries) query.addEventListener("change", onChange);
  return () => {
    observer.disconnect();
    for (const query of queries) query.removeEventListener("change", onChange);
  };
}

/**
 * The current values of custom properties. Forced colours are system colour names, which a worker
 * resolves to light colours regardless of the user's choice. Therefore the page resolves them here.
 */
export function shownProperties(): (property: string) => string {
  const style = getComputedStyle(document.documentElement);
  return (property) => {
    const value = style.getPropertyValue(property);
    if (!/^ ?[A-Z][A-Za-z]+$/.test(value)) return value;
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.color = value;
    const { color } = getComputedStyle(probe);
    probe.remove();
    return color;
  };
}

/**
 * Observes moves of the window to a screen with another pixel density.
 * @returns a function that stops observing
 */
export function observePixelRatio(onChange: (pixelRatio: number) => void): () => void {
  let query: MediaQueryList | null = null;
  const listen = (): void => {
    query?.removeEventListener("change", listen);
    query = window.matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    query.addEventListener("change", listen);
    onChange(window.devicePixelRatio);
  };
  listen();
  return () => query?.removeEventListener("change", listen);
}
