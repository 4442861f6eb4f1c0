/** Where an arrow key leads in a grid of tiles that fills its rows one after the other. */
export interface TileMove {
  /** as KeyboardEvent.key */
  key: string;
  /** index of the tile with the focus */
  from: number;
  count: number;
  columns: number;
  /** whether rows run from right to left */
  isRtl: boolean;
}

/** @returns the index of the next tile; null for other keys, and where there is none in that direction */
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
