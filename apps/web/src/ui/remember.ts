/** A function that answers the same question only once; for few questions, asked many times a second. */
export function remember<Question, Answer>(
  answer: (question: Question) => Answer,
): (question: Question) => Answer {
  const known = new Map<Question, Answer>();
  return (question) => {
    if (known.has(question)) return known.get(question) as Answer;
    const fresh = answer(question);
    known.set(question, fresh);
    return fresh;
  };
}
