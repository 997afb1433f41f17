"""What the ranks of a run have sent to each other, as Open MPI counts it."""
import dataclasses
import pathlib


def settings_of_counts(prefix):
    """Environment variables with which each rank writes its counts to `prefix`.RANK.prof."""
    settings = {"enable": "2", "enable_output": "3", "filename": str(prefix)}
    return {f"OMPI_MCA_pml_monitoring_{name}": value for name, value in settings.items()}


@dataclasses.dataclass
class Traffic:
    """By rank, of the whole run."""
    messages: list     # point to point, without those that collective operations are made of
    bytes: list
    collectives: list  # operations of all ranks of a communicator: reductions, barriers, gathers

    @classmethod
    def read(cls, prefix, n_ranks):
        """None if not all ranks have written their counts."""
        traffic = cls([], [], [])
        for rank in range(n_ranks):
            path = pathlib.Path(f"{prefix}.{rank}.prof")
            if not path.exists():
                return None
            sent, size, collectives, n_members = 0, 0, 0, 0
            for line in path.read_text().split("\n"):
                kind, *words = line.split("\t")
                if kind == "E":
                    size += int(words[2].split()[0])
                    sent += int(words[3].split()[0])
                elif kind == "D":
                    n_members = words[1].count(",") + 1
                elif kind in ("A2A", "A2O", "O2A") and n_members > 1:
                    collectives += int(words[2].split()[0])
            traffic.messages.append(sent)
            traffic.bytes.append(size)
            traffic.collectives.append(collectives)
        return traffic
