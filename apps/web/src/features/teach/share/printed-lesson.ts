import type { LessonDocument } from "@corridor/challenge";
import { sharedSearch } from "../../../model/preferences/language.ts";
import {
  printedLink,
  printedMazes,
  type PrintedContent,
} from "../../../ui/print/printed-content.ts";
import { shareSizesOf } from "./share-sizes.ts";

/** A lesson for paper, with the link that it has without a relay. @param lesson may be unfinished */
export function printedLesson(lesson: LessonDocument): PrintedContent {
  const { link } = shareSizesOf(lesson);
  const { origin, search } = location;
  return {
    language: lesson.language,
    mazes: printedMazes(lesson),
    link: printedLink(link === null ? null : `${origin}/${sharedSearch(search)}#${link}`),
  };
}
