/** A text of a teacher, in the language of the lesson. */
import { directionOf } from "../../text/direction.ts";

interface TeacherTextProps {
  text: string;
  /** BCP 47 tag of the lesson; null: that of the page */
  language: string | null;
  className?: string | undefined;
  /** a paragraph is aligned by its own direction */
  as?: "span" | "p";
}

export function TeacherText({ text, language, className, as: Part = "span" }: TeacherTextProps) {
  return (
    <Part className={className} lang={language ?? undefined} dir={directionOf(language)}>
      {text}
    </Part>
  );
}
