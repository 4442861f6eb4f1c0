/** A key press in a grid of tiles, which fills one row after the other. */
export interface TileMove {
  /** as KeyboardEvent.key */
  key: string;
  /** index of the focused tile */
  from: number;
  count: number;
  columns: number;
  /** whether rows run from right to left */
  isRtl: boolean;
}

/** @returns the index of the next tile; null for other keys, and if that direction has no tile */
export function nextTile({ key, from, count, columns, isRtl }: TileMove): number | null {
  const onward = isRtl ? -1 : 1;
  const steps: Readonly<Record<string, number>> = {
    ArrowRight: onward,
    ArrowLeft: -onward,
    ArrowDown: columns,
    ArrowUp: -columns,
    Home: -from,
    End: count - 1 - from,
  };
  const step = steps[key];
  if (step === undefined || from < 0) return null;
  const to = from + step;
  return to >= 0 && to < count ? to : null;
}
