/** All mazes of a set as one tab stop; arrow keys move from maze to maze. */
import {
  useCallback,
  useDeferredValue,
  useEffect,
  useRef,
  useState,
  type KeyboardEvent,
} from "react";
import { useTranslation } from "react-i18next";
import type { TrialResult } from "../../simulator/protocol/trial-messages.ts";
import { nextTile } from "./next-tile.ts";
import styles from "./other-mazes.module.css";
import { TrialTile } from "./TrialTile.tsx";

interface TrialGridProps {
  seeds: readonly number[];
  results: ReadonlyMap<number, TrialResult>;
  /** results whose pictures are drawn */
  pictured: ReadonlyMap<number, TrialResult>;
  onOpen: (result: TrialResult) => void;
}

export function TrialGrid({ seeds, results, pictured, onOpen }: TrialGridProps) {
  const { t, i18n } = useTranslation("otherMazes", { useSuspense: false });
  // Outcomes are displayed first, and pictures as soon as the page has time.
  const drawn = useDeferredValue(pictured);
  const list = useRef<HTMLUListElement>(null);
  const [at, setAt] = useState(0);
  const newest = useRef(onOpen);
  useEffect(() => {
    newest.current = onOpen;
  });
  // A stable function: a new `onOpen` does not render all tiles again.
  const open = useCallback((result: TrialResult) => newest.current(result), []);

  function onKeyDown(event: KeyboardEvent<HTMLUListElement>): void {
    const tiles = [...(list.current?.querySelectorAll("button") ?? [])];
    const from = tiles.indexOf(event.target as HTMLButtonElement);
    const isRtl = getComputedStyle(event.currentTarget).direction === "rtl";
    const tops = tiles.map((tile) => tile.getBoundingClientRect().top);
    const columns = tops.filter((top) => top === tops[0]).length;
    const to = nextTile({ key: event.key, from, count: tiles.length, columns, isRtl });
    if (to === null) return;
    event.preventDefault();
    setAt(to);
    tiles[to]?.focus();
  }

  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-interactions
    <ul
      ref={list}
      className={styles["grid"]}
      aria-label={t("list")}
      onKeyDown={onKeyDown}
      onFocus={(event) => {
        const tiles: Element[] = [...event.currentTarget.querySelectorAll("button")];
        setAt(Math.max(0, tiles.indexOf(event.target)));
      }}
    >
      {seeds.map((seed, index) => (
        <TrialTile
          key={seed}
          seed={seed}
          result={results.get(seed) ?? null}
          picture={drawn.get(seed)?.maze ?? null}
          isStop={index === at}
          onOpen={open}
          t={t}
          language={i18n.language}
        />
      ))}
    </ul>
  );
}
