/** The pictures of students' mazes. The worker draws them on a canvas above the page. */
import { useEffect, useId, useRef, type ReactNode } from "react";
import { classNames } from "../../ui/class-names.ts";
import { useContent } from "./dashboard-context.ts";
import { showPictures } from "./show-pictures.ts";
import styles from "./student-card.module.css";

interface StudentPictureProps {
  student: number;
  /** whether the picture is out of date */
  isOld?: boolean;
}

/** The place of a picture in a picture area. */
export function StudentPicture({ student, isOld = false }: StudentPictureProps) {
  return (
    <div
      className={styles["picture"]}
      data-picture={student}
      data-old={isOld || undefined}
      aria-hidden="true"
    />
  );
}

interface PictureAreaProps {
  className?: string | undefined;
  children: ReactNode;
}

/** Shows all pictures inside of it. */
export function PictureArea({ className, children }: PictureAreaProps) {
  const { dashboard } = useContent();
  const id = useId();
  const area = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const { current } = area;
    return current === null ? undefined : showPictures(current, dashboard, id);
  }, [dashboard, id]);
  return (
    <div ref={area} className={classNames(styles["area"], className)}>
      {children}
    </div>
  );
}
