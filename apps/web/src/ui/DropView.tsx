/** A view of a page that takes files: dropped anywhere, or pasted outside of a field. */
import { useEffect, useEffectEvent, useState, type ReactNode } from "react";
import { listenForFiles, type TextFile } from "./incoming-files.ts";
import styles from "./drop-view.module.css";

interface DropViewProps {
  title: string;
  /** shown over the view while files are dragged over the page */
  drop: string;
  onFiles: (files: readonly TextFile[]) => void;
  /** called with text that is pasted outside of a field */
  onText: (text: string) => void;
  children: ReactNode;
}

export function DropView({ title, drop, onFiles, onText, children }: DropViewProps) {
  const [isOver, setOver] = useState(false);
  const take = useEffectEvent(onFiles);
  const pasted = useEffectEvent(onText);
  useEffect(
    () =>
      listenForFiles({
        over: setOver,
        take: (files) => take(files),
        pasted: (text) => pasted(text),
      }),
    [],
  );
  return (
    <div className={styles["view"]}>
      <h2 className={styles["title"]}>{title}</h2>
      {children}
      {isOver && <p className={styles["over"]}>{drop}</p>}
    </div>
  );
}
