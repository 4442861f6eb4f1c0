/** Which cards each filter shows. */
import {
  isClassPaused,
  resultsTask,
  type DashboardState,
} from "../../model/classroom/dashboard.ts";
import {
  filters,
  groupedStudent,
  isIn,
  notHere,
  type Filter,
  type GroupedStudent,
} from "../../model/classroom/student-group.ts";

/** The filters that show each student, as bits, in the order of the cards. */
export function cardFilters(state: DashboardState): number[] {
  const { order, students, shown, verifications } = state;
  const task = resultsTask(state);
  const now = { shown, verifications, isPaused: isClassPaused(state) };
  return order.order.map((number) => {
    const student = students.get(number);
    return student === undefined ? 0 : bitsOf(groupedStudent(student, task, now));
  });
}

/** The filters that show students who have not joined. */
export const notHereFilters = bitsOf(notHere);

export function hasFilter(bits: number, filter: Filter): boolean {
  return (bits & bitOf(filter)) !== 0;
}

function bitsOf(student: GroupedStudent): number {
  return filters.reduce((bits, each) => (isIn(each, student) ? bits | bitOf(each) : bits), 0);
}

function bitOf(filter: Filter): number {
  return 1 << filters.indexOf(filter);
}
