/* Says that it runs. */
globalThis.postMessage("here");
