#include <stickslip/simulation/checkpoint_damage.h>

#include <stickslip/simulation/cell_records.h>
#include <stickslip/simulation/checkpoint_description.h>
#include <stickslip/simulation/checkpoint_directory.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <vector>

namespace stickslip
{
  namespace
  {
    std::string
    find_damage_of_cells(const std::string &file, const std::uint64_t identity)
    {
      CellRecordReader    reader(file, identity);
      std::vector<double> record;
      for (unsigned int i = 0; i < reader.n_cells(); ++i)
        if (!reader.read(i, record))
          return "'" + file + "': its data are damaged";
      return reader.error();
    }
  } // namespace



  std::string
  find_damage(const std::string &checkpoint)
  {
    std::ifstream file(path_of_description(checkpoint), std::ios::binary);
    if (!file)
      return "it has no description";
    std::ostringstream content;
    content << file.rdbuf();
    CheckpointDescription description;
    std::string           damage = description.parse(content.str());
    for (unsigned int n = 0; damage.empty() && n < description.n_files; ++n)
      damage = find_damage_of_cells(path_of_cells(checkpoint, n),
                                    description.identity);
    return damage;
  }



  std::string
  name_whole_checkpoint_beside(const std::string &checkpoint)
  {
    const std::string other = checkpoint_beside(checkpoint);
    return !other.empty() && find_damage(other).empty()
             ? " The checkpoint '" + other + "' is whole."
             : "";
  }



  std::string
  describe_damage(const std::string &checkpoint, const std::string &damage)
  {
    return "--restart: the checkpoint '" + checkpoint +
           "' is damaged: " + damage + "." +
           name_whole_checkpoint_beside(checkpoint);
  }
} // namespace stickslip
