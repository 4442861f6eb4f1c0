import { describe, expect, it } from "vitest";
import { createStore } from "zustand/vanilla";
import { followText } from "./follow-text.ts";

function follow() {
  const store = createStore(() => ({ x: 1.04, y: 0 }));
  const written: string[] = [];
  const end = followText(
    store,
    ({ x }) => x.toFixed(1),
    (text) => written.push(text),
  );
  return { store, written, end };
}

describe("a text that moves with the run", () => {
  it("is written at once, and then only when it changes", () => {
    const { store, written } = follow();
    store.setState({ y: 5 });
    store.setState({ x: 1.01 });
    expect(written).toEqual(["1.0"]);
    store.setState({ x: 2.5 });
    store.setState({ x: 1 });
    expect(written).toEqual(["1.0", "2.5", "1.0"]);
  });

  it("has no subscription after it is unmounted", () => {
    const { store, written, end } = follow();
    end();
    store.setState({ x: 9 });
    expect(written).toEqual(["1.0"]);
  });
});
